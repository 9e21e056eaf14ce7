using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.Drivers;

public sealed class SmoothingTests : SourceFixture
{
    [Fact]
    public void A_smoothed_figure_is_behind_its_performer_until_smoothing_ends()
    {
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(AddSimulator(motion: SimulatedMotion.WalkAndGestures));
        driver.PartSmoothing.Set(BodyParts.All, new SmoothingAmount(0.2f, 0));
        Loop.RunUntil(() => driver.IsDriving);
        Assert.False(driver.Smoothing);
        Assert.InRange(Behind(driver, figure), 0, 0.2f);

        driver.Smoothing = true;
        float most = 0;
        Loop.RunUntil(() => (most = Math.Max(most, Behind(driver, figure))) > 3);

        driver.Smoothing = false;
        Loop.Frame();
        Assert.InRange(Behind(driver, figure), 0, 0.2f);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Theory]
    [InlineData(true, false)]
    [InlineData(false, true)]
    public void Another_place_of_the_stage_is_reached_at_once(bool smooths, bool plants)
    {
        MocapSource source = Add(Serve(new BroadcasterOptions { Sources = [new PlacedActor()], IncludeDisplacement = true }), static source => source.Resample = false);
        TestFigure figure = TestFigure.Build("Figure");
        HumanoidDriver driver = figure.Drive(source);
        (driver.Smoothing, driver.FootPlanting) = (smooths, plants);
        driver.PartSmoothing.Set(BodyParts.All, new SmoothingAmount(0.1f, 0));
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(0.5f);
        (Vector3 hips, Vector3 foot) = (figure[Bone.Hips].position, figure[Bone.LeftFoot].position);

        source.Stage.Offset = new Vector3(0.05f, 0, 0);
        Loop.Frame();

        // The figure's root is scaled by 1.5.
        Assert.Equal(0.075f, (figure[Bone.Hips].position - hips).magnitude, 0.01f);
        Assert.Equal(0.075f, (figure[Bone.LeftFoot].position - foot).magnitude, 0.02f);
    }

    [Fact]
    public void Noise_becomes_smaller_in_the_smoothed_parts_only()
    {
        Broadcaster server = Serve(new TremblingActor());
        MocapSource source = Add(server, static source => source.Resample = false);
        HumanoidDriver driver = TestFigure.Build("Figure").Drive(source);
        driver.Smoothing = true;
        driver.PartSmoothing.Set(BodyParts.All, new SmoothingAmount(30, 20, 10));
        driver.PartSmoothing.Set(BodyParts.Arms, new SmoothingAmount(0.5f, 0));
        Loop.RunUntil(() => driver.IsDriving);
        Loop.RunFor(1);

        // The noise stays smaller for a while. A busy computer leaves frames out, and noise in frames that are far apart is smoothed less.
        float since = Time.time;
        Loop.RunUntil(() =>
        {
            if (!IsSmoothed())
                since = Time.time;
            return Time.time - since > 0.3f;
        });

        bool IsSmoothed()
        {
            (double rawArms, double arms) = driver.ActiveSmoothing!.GetNoise(BodyParts.Arms);
            return rawArms is > 0.05 and < 5 && arms < rawArms / 5 && driver.ActiveSmoothing.GetNoise(BodyParts.Legs).After > 3 * arms;
        }
    }

    [Fact]
    public void Parts_share_their_amount_in_groups()
    {
        var parts = new PartSmoothing();
        parts.Set(BodyParts.Head, new SmoothingAmount(1, 4));
        parts.Set(BodyParts.LeftFingers | BodyParts.RightLeg, new SmoothingAmount(5, 6));

        Assert.Equal((1, 4), (parts.Get(BodyParts.Hips).MinCutoff, parts.Get(BodyParts.Spine).Beta));
        Assert.Equal((5, 6), (parts.Get(BodyParts.RightFingers).MinCutoff, parts.Get(BodyParts.LeftLeg).Beta));
        Assert.Equal(3, parts.Get(BodyParts.RightArm).MinCutoff);
        Assert.Throws<ArgumentOutOfRangeException>(() => parts.Get(BodyParts.Arms));
    }

    [Theory]
    [InlineData(float.NaN, float.NaN, float.NaN)]
    [InlineData(0, -1, 0)]
    [InlineData(float.PositiveInfinity, float.PositiveInfinity, -3)]
    public void Amounts_out_of_range_do_no_harm(float cutoff, float beta, float derivative)
    {
        HumanoidDriver driver = TestFigure.Build("Figure").Drive(AddSimulator());
        driver.Smoothing = true;
        driver.PartSmoothing.Set(BodyParts.All, new SmoothingAmount(cutoff, beta, derivative));
        Loop.RunUntil(() => driver.IsDriving);
        Loop.Frames(5);

        Assert.True(driver.IsDriving);
        Assert.Empty(ConsoleLog.Entries);
    }

    // In degrees: the left hand, whose world rotation has the delay of the whole arm and the spine.
    private static float Behind(HumanoidDriver driver, TestFigure figure) =>
        Quaternion.Angle(driver.Performer!.GetRotation(Bone.LeftHand), figure.Turn(Bone.LeftHand));

    private sealed class TremblingActor : MotionSource
    {
        public override double FrameRate => 100;

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override void GetPose(long frame, Span<BoneTransform> pose)
        {
            SkeletonBody.GetDefault().CopyRestPose(pose);
            var random = new System.Random((int)frame);
            for (int bone = 1; bone < BoneHierarchy.BoneCount; bone++)
                pose[bone] = pose[bone] with { Rotation = System.Numerics.Quaternion.CreateFromAxisAngle(System.Numerics.Vector3.UnitX, 0.04f * (random.NextSingle() - 0.5f)) };
        }

        public override FootContacts GetFootContacts(long frame) => new(true, true);
    }
}
