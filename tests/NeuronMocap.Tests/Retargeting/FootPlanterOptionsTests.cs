using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class FootPlanterOptionsTests
{
    private const double Rate = 60;

    [Theory]
    [InlineData(FootRotation.Keep)]
    [InlineData(FootRotation.Flatten)]
    public void The_sole_follows_the_actor_or_stays_flat(FootRotation rotation)
    {
        TargetRig rig = new StandingRig().WithAxes(new Random(3)).Create();
        var walk = new FootWalk(rig, SkeletonBody.GetDefault(), Rate, planting: new FootPlanterOptions { FootRotation = rotation });
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        SkeletonBody.GetDefault().CopyRestPose(pose);
        pose[(int)Bone.LeftFoot] = pose[(int)Bone.LeftFoot] with { Rotation = Quaternion.CreateFromYawPitchRoll(0.4f, -0.2f, 0.15f) };
        for (int frame = 0; frame < 30; frame++)
            walk.Add(pose, new FootContacts(Left: true, Right: true));

        int foot = rig.GetNode(HumanoidBone.LeftFoot);
        Quaternion turn = walk.Pose.WorldRotations[foot] * Quaternion.Conjugate(rig.RestRotations[foot]);
        Vector3 up = Vector3.Transform(Vector3.UnitY, turn);
        Vector3 ahead = Vector3.Transform(Vector3.UnitZ, turn);
        Assert.Equal(rotation == FootRotation.Flatten ? 1 : Vector3.Transform(Vector3.UnitY, Quaternion.CreateFromYawPitchRoll(0.4f, -0.2f, 0.15f)).Y, up.Y, 1e-3f);
        Assert.Equal(-0.4f, MathF.Atan2(ahead.X, ahead.Z), 0.05f);
    }

    [Fact]
    public void Undriven_legs_and_hips_are_left_alone()
    {
        var options = new RetargetOptions();
        options.Weights.SetPart(BodyParts.LeftLeg | BodyParts.Hips, 0);
        FootWalk walk = FootWalk.OfActor(new StandingRig().Create(), Rate, 4, options: options);
        Assert.Equal(0, walk.MaxHipsShift);
        Assert.All(Enumerable.Range(0, walk.Count), frame => Assert.Equal(walk.FreeAnkle(0, frame), walk.Ankle(0, frame)));
        Assert.NotEqual(walk.FreeAnkle(1, walk.Count - 1), walk.Ankle(1, walk.Count - 1));
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(0.5, 1)]
    public void Blends_may_take_no_time_or_long(double blendIn, double blendOut)
    {
        var planting = new FootPlanterOptions { BlendIn = TimeSpan.FromSeconds(blendIn), BlendOut = TimeSpan.FromSeconds(blendOut), FootRotation = FootRotation.Flatten };
        FootWalk walk = FootWalk.OfActor(StandingRig.Random(new Random(4)).Create(), Rate, 8, planting: planting);
        Assert.True(walk.LargestSlide(planted: true) < FootWalk.Still, walk.Describe("Blends"));
        Assert.True(walk.LargestTurn < 100, walk.Describe("Blends"));
    }

    [Fact]
    public void Options_are_checked()
    {
        var options = new FootPlanterOptions();
        Assert.Throws<ArgumentOutOfRangeException>(() => options.BlendIn = TimeSpan.FromSeconds(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => options.BlendOut = TimeSpan.FromTicks(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => options.GroundHeight = float.PositiveInfinity);
        Assert.Throws<ArgumentOutOfRangeException>(() => options.MaxHipsShift = 1.1f);
        Assert.Equal((0.1, 0.2, 0f, 0.1f), (options.BlendIn.TotalSeconds, options.BlendOut.TotalSeconds, options.GroundHeight, options.MaxHipsShift));
    }
}
