using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class RootMotionTests
{
    private const float Height = 0.84102f;
    private static readonly Vector3 Way = new(-1, 0.2f, 0.5f);

    [Theory]
    [InlineData(RootMotion.Full, -1, 0.2f, 0.5f)]
    [InlineData(RootMotion.Horizontal, -1, 0, 0.5f)]
    [InlineData(RootMotion.InPlace, 0, 0.2f, 0)]
    public void Hip_motion_is_scaled_by_leg_length(RootMotion motion, float x, float y, float z)
    {
        foreach (float size in (ReadOnlySpan<float>)[0.5f, 1, 2])
        {
            Vector3 place = HipsOf(TestRigs.Humanoid(size), new RetargetOptions { RootMotion = motion });
            AssertNear((new Vector3(0, Height, 0) + new Vector3(x, y, z)) * size, place);
        }
    }

    [Fact]
    public void A_given_scale_replaces_leg_length()
    {
        Vector3 place = HipsOf(TestRigs.Humanoid(2), new RetargetOptions { Scale = 0.1f });
        AssertNear(new Vector3(0, 2 * Height, 0) + (Way * 0.1f), place);
    }

    [Fact]
    public void The_height_offset_is_in_metres_of_the_character()
    {
        foreach (RootMotion motion in Enum.GetValues<RootMotion>())
        {
            var options = new RetargetOptions { RootMotion = motion };
            Vector3 before = HipsOf(TestRigs.Humanoid(2), options);
            options.HeightOffset = -0.03f;
            AssertNear(before + new Vector3(0, -0.03f, 0), HipsOf(TestRigs.Humanoid(2), options));
        }
    }

    // A character that lies in its root, as in Z-up files. Its root motion lies too.
    [Fact]
    public void Motion_and_offset_turn_with_the_character()
    {
        var lying = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2);
        RigNode[] nodes = TestRigs.Under(new RigNode("Armature", -1, new Vector3(3, 4, 5), lying), TestRigs.HumanoidNodes());
        var rig = TargetRig.CreateHumanoid(nodes, TestRigs.Under(TestRigs.NodeOf()));
        AssertNear(Vector3.UnitZ, rig.Up);

        RetargetedPose result = Retarget(rig, SkeletonBody.GetDefault(), Way, new RetargetOptions { HeightOffset = 0.1f });
        AssertNear(new Vector3(0, Height + 0.1f, 0) + Way, result.HipsLocalPosition);
        result.UpdateWorld();
        AssertNear(new Vector3(3, 4, 5) + Vector3.Transform(new Vector3(0, Height + 0.1f, 0) + Way, lying), result.WorldPositions[rig.HipsNode]);
    }

    [Fact]
    public void The_characters_rest_position_is_the_actors_origin()
    {
        RigNode[] nodes = TestRigs.HumanoidNodes();
        nodes[0] = nodes[0] with { Position = new Vector3(0.1f, 1.1f, -0.2f) };
        AssertNear(nodes[0].Position + Way, HipsOf(TargetRig.CreateHumanoid(nodes, TestRigs.NodeOf()), new RetargetOptions()));
    }

    // The hips of a hierarchy may be anywhere. The position of the feet shows how high they stand.
    [Theory]
    [InlineData(0)]
    [InlineData(93)]
    public void The_actors_height_is_measured_from_the_feet(float offset)
    {
        Vector3[] offsets = SkeletonBody.GetDefault().Offsets.ToArray();
        offsets[0] = new Vector3(0, offset, 0);
        TargetRig rig = TestRigs.Humanoid();
        AssertNear(new Vector3(0, Height, 0) + Way, Retarget(rig, new SkeletonBody(offsets), Way, new RetargetOptions()).HipsLocalPosition);
    }

    [Fact]
    public void The_actors_legs_count()
    {
        TargetRig rig = TestRigs.Humanoid();
        var tall = SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperLeg = 0.6f, LowerLeg = 0.6f });
        var retargeter = new Retargeter(rig, tall);
        Assert.Equal(0.74102f / 1.2f, retargeter.Scale, 1e-5f);
        retargeter.SetBody(SkeletonBody.GetDefault());
        Assert.Equal(1, retargeter.Scale, 1e-5f);
        retargeter.Options.Scale = 3;
        Assert.Equal(3, retargeter.Scale);
    }

    [Fact]
    public void Hip_height_replaces_missing_legs()
    {
        HumanoidBone[] shins = [HumanoidBone.LeftLowerLeg, HumanoidBone.RightLowerLeg];
        Assert.Equal(2, new Retargeter(TestRigs.Humanoid(2, shins), SkeletonBody.GetDefault()).Scale, 1e-5f);
        Assert.Equal(2, new Retargeter(TestRigs.Humanoid(2, shins[0]), SkeletonBody.GetDefault()).Scale, 1e-5f);

        RigNode[] nodes = TestRigs.HumanoidNodes();
        nodes[0] = nodes[0] with { Position = Vector3.Zero };
        Assert.Equal(1, new Retargeter(TargetRig.CreateHumanoid(nodes, TestRigs.NodeOf(shins)), SkeletonBody.GetDefault()).Scale);
    }

    [Fact]
    public void The_reference_moves_and_turns_the_whole_body()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = RandomPoses.Pose(new Random(1));
        var reference = new BoneTransform(new Vector3(10, 20, 30), RandomPoses.Turn(new Random(2)));
        var result = new RetargetedPose(rig);
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        Assert.True(retargeter.TryRetarget(pose, result, reference));
        Quaternion[] expected = result.LocalRotations.ToArray();
        Vector3 place = result.HipsLocalPosition;

        pose[0] = reference.Apply(pose[0]);
        Assert.True(retargeter.TryRetarget(pose, result));
        AssertNear(place, result.HipsLocalPosition);
        Assert.Equal(expected, result.LocalRotations.ToArray());
    }

    // Displacement belongs to the actor. The character keeps its own bones.
    [Fact]
    public void Only_the_hips_position_counts()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = RandomPoses.Pose(new Random(3));
        var one = new RetargetedPose(rig);
        var other = new RetargetedPose(rig);
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        Assert.True(retargeter.TryRetarget(pose, one));
        for (int bone = 1; bone < pose.Length; bone++)
            pose[bone] = pose[bone] with { Position = new Vector3(bone, 7, -bone) };

        Assert.True(retargeter.TryRetarget(pose, other));
        Assert.Equal(one.LocalRotations.ToArray(), other.LocalRotations.ToArray());
        Assert.Equal(one.HipsLocalPosition, other.HipsLocalPosition);
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void Options_must_be_finite(float value)
    {
        var options = new RetargetOptions();
        Assert.Throws<ArgumentOutOfRangeException>(() => options.HeightOffset = value);
        Assert.Throws<ArgumentOutOfRangeException>(() => options.Scale = value);
        Assert.Throws<ArgumentOutOfRangeException>(() => options.Scale = -1);
        Assert.Throws<ArgumentNullException>(() => options.Weights = null!);
        options.Scale = null;
        Assert.Null(options.Scale);
    }

    private static Vector3 HipsOf(TargetRig rig, RetargetOptions options) => Retarget(rig, SkeletonBody.GetDefault(), Way, options).HipsLocalPosition;

    private static RetargetedPose Retarget(TargetRig rig, SkeletonBody body, Vector3 way, RetargetOptions options)
    {
        BoneTransform[] pose = TestRigs.RestPose(SkeletonBody.GetDefault());
        pose[0] = pose[0] with { Position = UnityAxes.FromUnityPosition(new Vector3(0, Height, 0) + way) };
        var result = new RetargetedPose(rig);
        Assert.True(new Retargeter(rig, body, options).TryRetarget(pose, result));
        return result;
    }

    private static void AssertNear(Vector3 expected, Vector3 actual) =>
        Assert.True(Vector3.Distance(expected, actual) <= 1e-5f, $"{expected} and {actual}");
}
