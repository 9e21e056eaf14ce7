using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class RetargeterRejectionTests
{
    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(float.NegativeInfinity)]
    public void One_broken_number_rejects_the_frame(float broken)
    {
        TargetRig rig = TestRigs.Humanoid();
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var result = new RetargetedPose(rig);
        BoneTransform[] good = RandomPoses.Pose(new Random(1));
        Assert.True(retargeter.TryRetarget(good, result));
        Quaternion[] before = result.LocalRotations.ToArray();
        Vector3 hips = result.HipsLocalPosition;
        long count = 0;
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            for (int component = 0; component < 7; component++)
            {
                BoneTransform[] pose = RandomPoses.Pose(new Random(2));
                pose[bone] = Broken(pose[bone], component, broken);
                Assert.False(retargeter.TryRetarget(pose, result), $"{(Bone)bone}, {component}");
                Assert.Equal(++count, retargeter.RejectedCount);
            }
        }

        Assert.Equal(before, result.LocalRotations.ToArray());
        Assert.Equal(hips, result.HipsLocalPosition);
        Assert.True(retargeter.TryRetarget(good, result));
        Assert.Equal(count, retargeter.RejectedCount);
    }

    [Fact]
    public void A_broken_reference_rejects_the_frame()
    {
        TargetRig rig = TestRigs.Humanoid();
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var result = new RetargetedPose(rig);
        BoneTransform[] pose = RandomPoses.Pose(new Random(3));
        for (int component = 0; component < 7; component++)
            Assert.False(retargeter.TryRetarget(pose, result, Broken(BoneTransform.Identity, component, float.NaN)));

        Assert.Equal(7, retargeter.RejectedCount);
    }

    [Fact]
    public void A_rotation_without_direction_rejects_the_frame()
    {
        TargetRig rig = TestRigs.Humanoid();
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var result = new RetargetedPose(rig);
        BoneTransform[] pose = RandomPoses.Pose(new Random(4));
        pose[20] = pose[20] with { Rotation = default };
        Assert.False(retargeter.TryRetarget(pose, result));
        pose[20] = pose[20] with { Rotation = new Quaternion(1e30f, 0, 0, 1) };
        Assert.False(retargeter.TryRetarget(pose, result));
        Assert.False(result.IsDriven(rig.HipsNode));
    }

    [Fact]
    public void Rotations_of_other_lengths_are_normalised()
    {
        TargetRig rig = TestRigs.Humanoid();
        var random = new Random(5);
        BoneTransform[] pose = RandomPoses.Pose(random);
        BoneTransform[] stretched = [.. pose.Select(bone => bone with { Rotation = bone.Rotation * MathF.Pow(10, random.Next(-2, 18)) })];
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var one = new RetargetedPose(rig);
        var other = new RetargetedPose(rig);
        Assert.True(retargeter.TryRetarget(pose, one));
        Assert.True(retargeter.TryRetarget(stretched, other));
        for (int node = 0; node < rig.Nodes.Length; node++)
            Assert.True(Affine.Turned(one.LocalRotations[node]).AngleTo(other.LocalRotations[node]) < 3e-6);
    }

    [Fact]
    public void Arguments_are_checked()
    {
        TargetRig rig = TestRigs.Humanoid();
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        Assert.Throws<ArgumentException>(() => retargeter.TryRetarget(new BoneTransform[58], new RetargetedPose(rig)));
        Assert.Throws<ArgumentException>(() => retargeter.TryRetarget(new BoneTransform[59], new RetargetedPose(TestRigs.Humanoid())));
        Assert.Throws<ArgumentNullException>(() => retargeter.TryRetarget(new BoneTransform[59], null!));
        Assert.Throws<ArgumentNullException>(() => new Retargeter(null!, SkeletonBody.GetDefault()));
        Assert.Throws<ArgumentNullException>(() => new Retargeter(rig, null!));
        Assert.Throws<ArgumentNullException>(() => retargeter.SetBody(null!));
        Assert.Throws<ArgumentNullException>(() => new RetargetedPose(null!));
    }

    private static BoneTransform Broken(BoneTransform whole, int component, float value)
    {
        (Vector3 position, Quaternion rotation) = whole;
        switch (component)
        {
            case 0: position.X = value; break;
            case 1: position.Y = value; break;
            case 2: position.Z = value; break;
            case 3: rotation.X = value; break;
            case 4: rotation.Y = value; break;
            case 5: rotation.Z = value; break;
            default: rotation.W = value; break;
        }

        return new BoneTransform(position, rotation);
    }
}
