using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class FootPlanterTests
{
    private const double Rate = 60;

    private const float Still = FootWalk.Still;

    [Fact]
    public void A_planted_foot_stays_where_it_is_on_any_rig()
    {
        float slide = 0;
        for (int seed = 0; seed < 24; seed++)
        {
            var random = new Random(seed);
            FootWalk walk = FootWalk.OfActor(StandingRig.Random(random).Create(), Rate, 12, avatar: seed);
            string figures = walk.Describe($"Rig {seed}");
            Assert.True(walk.LargestSlide(planted: true) < Still, figures);
            Assert.True(walk.LargestMove(planted: true, after: walk.Planter.Options.BlendIn.TotalSeconds) < Still, figures);
            Assert.True(walk.FramesLetGo == 0, figures);
            Assert.True(walk.MaxHipsShift <= 0.1001f * walk.Rig.LegLength, figures);
            Assert.True(walk.LeastKnee > -1e-4f, figures);
            Assert.True(walk.LargestAddedSpeed() < 0.6f && walk.LargestKneeSpeed < 0.8f && walk.LargestTurn < 100, figures);
            slide = Math.Max(slide, walk.LargestSlide(planted: false));
        }

        // A control: without planting, the same walks slide.
        Assert.True(slide > 0.015f, $"{slide} m");
    }

    [Fact]
    public void Feet_of_a_drifting_actor_are_held()
    {
        for (int seed = 0; seed < 8; seed++)
        {
            var random = new Random(seed);
            TargetRig rig = StandingRig.Random(random).Create();
            var drift = new Vector3(random.Range(-4, 4), 0, random.Range(-4, 4));
            float scale = rig.LegLength / 0.741f * random.Range(0.8f, 1.1f);
            FootWalk walk = FootWalk.OfActor(rig, Rate, 12, seed, new RetargetOptions { Scale = scale }, drift: drift);

            string figures = walk.Describe($"Rig {seed}");
            Assert.True(walk.LargestSlide(planted: true) < Still && walk.LargestMove(planted: true, after: 0.1) < Still, figures);
            Assert.True(walk.LargestSlide(planted: false) > 0.03f && walk.FramesLetGo == 0, figures);
            Assert.True(walk.MaxHipsShift <= 0.1001f * rig.LegLength && walk.LeastKnee > -1e-4f, figures);
        }
    }

    [Theory]
    [InlineData(30, 120)]
    [InlineData(60, 240)]
    [InlineData(72, 144)]
    public void The_frame_rate_does_not_matter(int rate, int other)
    {
        // Both runs use the contacts of the slower one.
        TargetRig rig = StandingRig.Random(new Random(5)).Create();
        var actor = new SyntheticSource(other);
        int stride = other / rate;
        var slow = new FootWalk(rig, SkeletonBody.GetDefault(), rate);
        var fast = new FootWalk(rig, SkeletonBody.GetDefault(), other);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < 8 * other; frame++)
        {
            actor.GetPose(frame, pose);
            FootContacts contacts = actor.GetFootContacts(frame - (frame % stride));
            fast.Add(pose, contacts);
            if (frame % stride == 0)
                slow.Add(pose, contacts);
        }

        Assert.True(slow.LargestDistance(fast, stride) < 0.003f, $"{slow.LargestDistance(fast, stride)} m");
    }

    [Theory]
    [InlineData(0.01f)]
    [InlineData(39.37f)]
    public void A_scaled_and_turned_root_changes_nothing(float scale)
    {
        var plain = new StandingRig(0.35f, 0.5f, 0.1f, 0.3f, 0.3f);
        var scaled = new StandingRig(0.35f, 0.5f, 0.1f, 0.3f, 0.3f);
        scaled.Above.Add(new RigNode("Armature", -1, new Vector3(0.1f, 0.2f, 0), new Random(2).Rotation(), new Vector3(scale)));
        FootWalk one = FootWalk.OfActor(plain.Create(), Rate, 6);
        FootWalk other = FootWalk.OfActor(scaled.WithAxes(new Random(1)).Create(), Rate, 6);
        Assert.True(one.LargestDistance(other, 1) < 2e-4f, $"{one.LargestDistance(other, 1)} m");
    }

    [Theory]
    [InlineData(0, 1, 0, 180)]
    [InlineData(1, 0, 0, -90)]
    [InlineData(1, 0, 0, 90)]
    public void A_character_turned_in_its_root_stands_on_its_own_ground(float x, float y, float z, float degrees)
    {
        // Turned about its root, so that its soles are still at the root's height, whatever direction that is.
        StandingRig rig = new StandingRig(0.5f, 0.38f, 0.1f, 0.3f, 0.3f).WithAxes(new Random(2));
        var turn = Quaternion.CreateFromAxisAngle(new Vector3(x, y, z), degrees * MathF.PI / 180);
        rig.Turn(HumanoidBone.Hips, new Vector3(x, y, z), degrees).Move(HumanoidBone.Hips, Vector3.Transform(rig.At(HumanoidBone.Hips), turn) - rig.At(HumanoidBone.Hips));
        FootWalk walk = FootWalk.OfActor(rig.Create(), Rate, 8);
        FootWalk plain = FootWalk.OfActor(new StandingRig(0.5f, 0.38f, 0.1f, 0.3f, 0.3f).Create(), Rate, 8);

        Assert.True(walk.LeastKnee > -1e-4f && walk.FramesLetGo == 0, walk.Describe("Turned"));
        Assert.Equal(plain.Planter.HipsShift, walk.Planter.HipsShift, 1e-4f);
        for (int frame = 0; frame < walk.Count; frame++)
        {
            for (int side = 0; side < 2; side++)
                Assert.True(Vector3.Distance(Vector3.Transform(plain.Ankle(side, frame), turn), walk.Ankle(side, frame)) < 3e-4f, $"Frame {frame}");
        }
    }

    [Fact]
    public void A_generic_rig_is_held_as_well()
    {
        FootWalk walk = FootWalk.OfActor(TestRigs.Actor(SkeletonBody.GetDefault()), Rate, 8, drift: new Vector3(3, 0, 2));
        Assert.True(walk.LargestSlide(planted: true) < Still && walk.LargestSlide(planted: false) > 0.02f && walk.FramesLetGo == 0, walk.Describe("Generic"));
    }

    [Fact]
    public void A_sheared_rig_is_held_as_well()
    {
        (RigNode[] nodes, int[] nodeByBone) = new StandingRig().WithAxes(new Random(1)).Build();
        nodes[0] = nodes[0] with { Scale = new Vector3(1.1f, 1, 0.95f) };
        FootWalk walk = FootWalk.OfActor(TargetRig.CreateHumanoid(nodes, nodeByBone), Rate, 8);
        Assert.True(walk.Rig.IsSheared);
        Assert.True(walk.LargestSlide(planted: true) < 0.005f, walk.Describe("Sheared"));
    }

    [Fact]
    public void A_figure_at_rest_stays_at_rest()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            TargetRig rig = StandingRig.Random(new Random(seed)).Create();
            var walk = new FootWalk(rig, SkeletonBody.GetDefault(), Rate);
            BoneTransform[] rest = new BoneTransform[BoneHierarchy.BoneCount];
            SkeletonBody.GetDefault().CopyRestPose(rest);
            for (int frame = 0; frame < 60; frame++)
                walk.Add(rest, new FootContacts(Left: frame % 20 < 10, Right: true));

            Assert.True(walk.MaxHipsShift < 1e-3f, $"Rig {seed}: {walk.MaxHipsShift}");
            for (int side = 0; side < 2; side++)
                Assert.True(Vector3.Distance(walk.Ankle(side, 59), walk.FreeAnkle(side, 0)) < 1e-3f, $"Rig {seed}");
        }
    }

    [Fact]
    public void An_unreachable_foot_is_released_smoothly()
    {
        var walk = new FootWalk(new StandingRig().Create(), SkeletonBody.GetDefault(), Rate);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        SkeletonBody.GetDefault().CopyRestPose(pose);
        for (int frame = 0; frame < 180; frame++)
        {
            // The feet slide away at a metre a second while both contacts are reported.
            pose[0] = pose[0] with { Position = pose[0].Position + new Vector3(0, 0, 100f / 60) };
            walk.Add(pose, new FootContacts(Left: true, Right: true));
        }

        Assert.Equal(default, walk.Planter.Planted);
        Assert.InRange(walk.FramesLetGo, 120, 175);
        Assert.True(walk.LargestAddedSpeed() < 6, walk.Describe("Sliding"));
        Assert.True(Vector3.Distance(walk.Ankle(0, 179), walk.FreeAnkle(0, 179)) < 1e-3f, walk.Describe("Sliding"));
    }

    [Fact]
    public void Toes_of_a_planted_foot_stay_above_the_ground()
    {
        TargetRig rig = new StandingRig().Create();
        var walk = new FootWalk(rig, SkeletonBody.GetDefault(), Rate);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        SkeletonBody.GetDefault().CopyRestPose(pose);
        for (int frame = 0; frame < 60; frame++)
        {
            // The heel rises while the contact is reported.
            pose[(int)Bone.LeftFoot] = pose[(int)Bone.LeftFoot] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitX, Math.Max(0, frame - 20) * 0.02f) };
            walk.Add(pose, new FootContacts(Left: true, Right: true));
            Assert.True(walk.Pose.WorldPositions[rig.GetNode(HumanoidBone.LeftToes)].Y > 0.018f, $"Frame {frame}");
        }
    }

    [Fact]
    public void Knees_that_are_bent_backwards_are_bent_forward()
    {
        var walk = new FootWalk(new StandingRig().WithAxes(new Random(3)).Create(), SkeletonBody.GetDefault(), Rate);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < 120; frame++)
        {
            SkeletonBody.GetDefault().CopyRestPose(pose);
            float bend = MathF.Sin(frame / 10f) * 0.12f;
            pose[(int)Bone.LeftUpLeg] = pose[(int)Bone.LeftUpLeg] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitX, -bend) };
            pose[(int)Bone.LeftLeg] = pose[(int)Bone.LeftLeg] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitX, 2 * bend) };
            walk.Add(pose, new FootContacts(Left: frame % 60 < 30, Right: true));
        }

        Assert.True(walk.LeastKnee > -1e-4f, $"{walk.LeastKnee}");
    }

    [Fact]
    public void Feet_without_contact_follow_the_actor()
    {
        var walk = new FootWalk(new StandingRig().WithAxes(new Random(9)).Create(), SkeletonBody.GetDefault(), Rate);
        var actor = new SyntheticSource(Rate);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < 300; frame++)
        {
            actor.GetPose(frame, pose);
            walk.Add(pose, default);
        }

        Assert.All(Enumerable.Range(0, 600), i => Assert.True(Vector3.Distance(walk.FreeAnkle(i % 2, i / 2), walk.Ankle(i % 2, i / 2)) < 1e-5f));
    }

    [Fact]
    public void Rigs_without_legs_or_with_loose_ones_are_left_alone()
    {
        TargetRig rig = new StandingRig().Without(HumanoidBone.LeftLowerLeg).Without(HumanoidBone.RightFoot).Create();
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var pose = new RetargetedPose(rig);
        BoneTransform[] source = new BoneTransform[BoneHierarchy.BoneCount];
        new SyntheticSource().GetPose(0, source);
        Assert.True(retargeter.TryRetarget(source, pose));
        Quaternion[] before = pose.LocalRotations.ToArray();
        Vector3 hips = pose.HipsLocalPosition;

        new FootPlanter(rig).Plant(pose, new FootContacts(Left: true, Right: true), 0);

        Assert.Equal(before, pose.LocalRotations.ToArray());
        Assert.Equal(hips, pose.HipsLocalPosition);
        Assert.Throws<ArgumentException>(() => new FootPlanter(new StandingRig().Create()).Plant(pose, default, 0));
    }

    [Fact]
    public void Constant_time_and_long_gaps_are_handled()
    {
        TargetRig rig = new StandingRig().Create();
        var planter = new FootPlanter(rig);
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var pose = new RetargetedPose(rig);
        BoneTransform[] source = new BoneTransform[BoneHierarchy.BoneCount];
        var actor = new SyntheticSource();
        double[] times = [0, 0, 0.1, 0.05, double.NaN, 0.2, 100, 100.1, -5];
        for (int i = 0; i < times.Length; i++)
        {
            actor.GetPose(i, source);
            Assert.True(retargeter.TryRetarget(source, pose));
            planter.Plant(pose, actor.GetFootContacts(i), times[i]);
            Assert.All(pose.LocalRotations.ToArray(), rotation => Assert.Equal(1, rotation.Length(), 1e-4f));
        }

        planter.Reset();
        Assert.Equal((default, 0), (planter.Planted, planter.HipsShift));
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        TargetRig rig = StandingRig.Random(new Random(1)).Create();
        var planter = new FootPlanter(rig, new FootPlanterOptions { FootRotation = FootRotation.Flatten, GroundHeight = null });
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var pose = new RetargetedPose(rig);
        BoneTransform[] source = new BoneTransform[BoneHierarchy.BoneCount];
        var actor = new SyntheticSource();
        int frame = 0;
        Allocations.AssertNone(() =>
        {
            actor.GetPose(frame, source);
            retargeter.TryRetarget(source, pose);
            planter.Plant(pose, actor.GetFootContacts(frame), frame++ / 60.0);
        });
    }
}
