using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class ForwardKinematicsTests
{
    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void The_rest_pose_stands_on_the_ground_with_its_arms_out(SkeletonVariant variant)
    {
        BoneTransform[] world = new BoneTransform[59];
        ForwardKinematics.ToWorld(RestPose(variant), world, variant);

        AssertNear(new Vector3(0, 84.102f, 0), world[(int)Bone.Hips].Position);
        AssertNear(new Vector3(-9.5f, 10, 0), world[(int)Bone.RightFoot].Position);
        AssertNear(new Vector3(0, 144.102f, 0), world[(int)Bone.Head].Position);
        AssertNear(new Vector3(64, 130.002f, 0), world[(int)Bone.LeftHand].Position);
        Assert.All(world, transform => Assert.Equal(Quaternion.Identity, transform.Rotation));
    }

    [Fact]
    public void A_shoulder_rotation_moves_only_the_arm()
    {
        BoneTransform[] pose = RestPose(SkeletonVariant.Neck1);
        BoneTransform[] rest = new BoneTransform[59];
        BoneTransform[] world = new BoneTransform[59];
        ForwardKinematics.ToWorld(pose, rest);
        pose[(int)Bone.LeftArm] = pose[(int)Bone.LeftArm] with { Rotation = EulerAngles.ToQuaternion(new Vector3(0, 0, -90), RotationOrder.YXZ) };
        ForwardKinematics.ToWorld(pose, world);

        AssertNear(new Vector3(14, 130.002f, 0), world[(int)Bone.LeftArm].Position);
        AssertNear(new Vector3(14, 105.002f, 0), world[(int)Bone.LeftForeArm].Position);
        AssertNear(new Vector3(14, 80.002f, 0), world[(int)Bone.LeftHand].Position);
        AssertNear(rest[(int)Bone.RightHand].Position, world[(int)Bone.RightHand].Position);
        AssertNear(rest[(int)Bone.Head].Position, world[(int)Bone.Head].Position);
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void Random_poses_match_double_precision(SkeletonVariant variant)
    {
        for (int seed = 0; seed < 50; seed++)
        {
            var random = new Random(seed);
            BoneTransform[] pose = RandomPose(random);
            BoneTransform? root = seed % 2 == 0 ? null : RandomTransform(random);
            BoneTransform[] world = new BoneTransform[59];
            ForwardKinematics.ToWorld(pose, world, variant, root);
            AssertReference(pose, world, variant, root);
        }
    }

    [Fact]
    public void The_result_may_overwrite_the_pose()
    {
        BoneTransform[] pose = RandomPose(new Random(7));
        BoneTransform[] world = new BoneTransform[59];
        ForwardKinematics.ToWorld(pose, world, SkeletonVariant.Spine3, RandomTransform(new Random(8)));
        ForwardKinematics.ToWorld(pose, pose, SkeletonVariant.Spine3, RandomTransform(new Random(8)));
        Assert.Equal(world, pose);
    }

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void World_to_local_is_the_inverse(SkeletonVariant variant)
    {
        for (int seed = 0; seed < 50; seed++)
        {
            var random = new Random(seed);
            BoneTransform[] pose = RandomPose(random);
            BoneTransform? root = seed % 2 == 0 ? null : RandomTransform(random);
            BoneTransform[] world = new BoneTransform[59];
            BoneTransform[] back = new BoneTransform[59];
            ForwardKinematics.ToWorld(pose, world, variant, root);
            ForwardKinematics.ToLocal(world, back, variant, root);
            ForwardKinematics.ToLocal(world, world, variant, root);

            Assert.Equal(back, world);
            for (int bone = 0; bone < 59; bone++)
            {
                AssertNear(pose[bone].Position, back[bone].Position);
                Assert.True(Math.Abs(Quaternion.Dot(pose[bone].Rotation, back[bone].Rotation)) > 1 - 1e-5f);
            }
        }
    }

    [Fact]
    public void Only_59_transforms_are_read_and_written()
    {
        BoneTransform[] pose = [.. RandomPose(new Random(9)), new BoneTransform(new Vector3(float.NaN), default)];
        BoneTransform[] world = new BoneTransform[60];
        ForwardKinematics.ToWorld(pose, world);
        Assert.Equal(default, world[59]);
        Assert.All(world[..59], transform => Assert.False(float.IsNaN(transform.Position.X)));
    }

    [Fact]
    public void Fewer_than_59_transforms_are_refused()
    {
        BoneTransform[] enough = new BoneTransform[59];
        BoneTransform[] less = new BoneTransform[58];
        Assert.Equal("local", Assert.Throws<ArgumentException>(() => ForwardKinematics.ToWorld(less, enough)).ParamName);
        Assert.Equal("world", Assert.Throws<ArgumentException>(() => ForwardKinematics.ToWorld(enough, less)).ParamName);
        Assert.Equal("world", Assert.Throws<ArgumentException>(() => ForwardKinematics.ToLocal(less, enough)).ParamName);
        Assert.Equal("local", Assert.Throws<ArgumentException>(() => ForwardKinematics.ToLocal(enough, less)).ParamName);
    }

    [Fact]
    public void A_transform_applies_its_rotation_before_its_position()
    {
        var parent = new BoneTransform(new Vector3(1, 2, 3), EulerAngles.ToQuaternion(new Vector3(90, 0, 0), RotationOrder.YXZ));
        BoneTransform applied = parent.Apply(new BoneTransform(Vector3.UnitZ, Quaternion.Identity));

        AssertNear(new Vector3(2, 2, 3), applied.Position);
        AssertNear(new Vector3(2, 2, 3), parent.TransformPoint(Vector3.UnitZ));
        Assert.Equal(parent.Rotation, applied.Rotation);
        Assert.Equal(parent, BoneTransform.Identity.Apply(parent));
    }

    private static void AssertReference(BoneTransform[] pose, BoneTransform[] world, SkeletonVariant variant, BoneTransform? root)
    {
        var rotations = new ReferenceRotation[59];
        double[][] positions = new double[59][];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            BoneTransform local = pose[(int)bone];
            var rotation = ReferenceRotation.FromQuaternion(local.Rotation);
            double[] position = Doubles(local.Position);
            if (BoneHierarchy.GetParent(bone, variant) is { } parent)
                (rotation, position) = Place(rotations[(int)parent], positions[(int)parent], rotation, position);
            else if (root is { } reference)
                (rotation, position) = Place(ReferenceRotation.FromQuaternion(reference.Rotation), Doubles(reference.Position), rotation, position);

            (rotations[(int)bone], positions[(int)bone]) = (rotation, position);
            double error = position.Zip(Doubles(world[(int)bone].Position)).Max(pair => Math.Abs(pair.First - pair.Second));
            Assert.True(error < 1e-3, $"{bone} is off by {error} cm.");
            Assert.True(rotation.Distance(world[(int)bone].Rotation) < 1e-5, $"{bone} is turned otherwise.");
        }
    }

    private static double[] Doubles(Vector3 vector) => [vector.X, vector.Y, vector.Z];

    private static (ReferenceRotation Rotation, double[] Position) Place(
        ReferenceRotation parent, double[] origin, ReferenceRotation rotation, double[] position)
    {
        double[] turned = parent.Turn(position);
        return (parent.Times(rotation), [origin[0] + turned[0], origin[1] + turned[1], origin[2] + turned[2]]);
    }

    private static BoneTransform[] RestPose(SkeletonVariant variant) =>
        [.. BoneHierarchy.Bones.ToArray().Select(bone => new BoneTransform(DefaultOffsets.Get(bone, variant), Quaternion.Identity))];

    private static BoneTransform[] RandomPose(Random random) => [.. Enumerable.Range(0, 59).Select(_ => RandomTransform(random))];

    private static BoneTransform RandomTransform(Random random) => new(
        new Vector3(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f, random.NextSingle() - 0.5f) * 60,
        EulerAngles.ToQuaternion(new Vector3(random.NextSingle(), random.NextSingle(), random.NextSingle()) * 360, RotationOrder.YXZ));

    private static void AssertNear(Vector3 expected, Vector3 actual) =>
        Assert.True(Vector3.Distance(expected, actual) < 1e-3f, $"Expected {expected}, found {actual}.");
}
