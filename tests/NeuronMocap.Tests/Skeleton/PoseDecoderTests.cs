using System.Numerics;
using System.Runtime.InteropServices;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class PoseDecoderTests
{
    public static TheoryData<int, RotationOrder> Cases
    {
        get
        {
            var cases = new TheoryData<int, RotationOrder>();
            foreach (int count in (int[])[180, 186, 354, 360])
            {
                foreach (RotationOrder order in Enum.GetValues<RotationOrder>())
                    cases.Add(count, order);
            }

            return cases;
        }
    }

    [Theory, MemberData(nameof(Cases))]
    public void A_frame_matches_double_precision(int count, RotationOrder order)
    {
        Assert.True(ChannelLayout.TryFromValueCount(count, out ChannelLayout layout) || count == 180);
        foreach (SkeletonVariant variant in Enum.GetValues<SkeletonVariant>())
        {
            var random = new Random(count);
            float[] values = RandomValues(random, count);
            var body = SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperArm = 0.31f, Body = 0.55f }, variant);
            BoneTransform[] local = new BoneTransform[59];
            BoneTransform[] world = new BoneTransform[59];

            PoseDecoder.Decode(values, layout, order, body, local);
            ForwardKinematics.ToWorld(local, world, variant);

            AssertReference(values, layout, order, body, world);
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                var angles = MemoryMarshal.Cast<float, Vector3>(values.AsSpan(layout.GetRotationIndex(bone), 3))[0];
                Assert.Equal(EulerAngles.ToQuaternion(angles, order), local[(int)bone].Rotation);
            }
        }
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        float[] values = RandomValues(new Random(1), 354);
        BoneTransform[] pose = new BoneTransform[59];
        Vector3[] points = new Vector3[JointPositions.Count];
        var body = SkeletonBody.GetDefault();
        Allocations.AssertNone(() =>
        {
            PoseDecoder.Decode(values, new ChannelLayout(hasDisplacement: true, hasReference: false), RotationOrder.YXZ, body, pose);
            ForwardKinematics.ToWorld(pose, pose);
            JointPositions.Copy(pose, body, points);
            ForwardKinematics.ToLocal(pose, pose);
        });
    }

    [Fact]
    public void Too_few_values_too_little_room_and_unknown_orders_are_refused()
    {
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        var body = SkeletonBody.GetDefault();
        BoneTransform[] room = new BoneTransform[59];
        Assert.Equal("values", Assert.Throws<ArgumentException>(() => PoseDecoder.Decode(new float[353], layout, RotationOrder.YXZ, body, room)).ParamName);
        Assert.Equal("local", Assert.Throws<ArgumentException>(() => PoseDecoder.Decode(new float[354], layout, RotationOrder.YXZ, body, new BoneTransform[58])).ParamName);
        Assert.Throws<ArgumentOutOfRangeException>(() => PoseDecoder.Decode(new float[354], layout, (RotationOrder)6, body, room));
    }

    private static float[] RandomValues(Random random, int count)
    {
        float[] values = new float[count];
        for (int i = 0; i < count; i++)
            values[i] = (random.NextSingle() - 0.5f) * (i % 7 == 0 ? 2000 : 360);

        return values;
    }

    // The bound is the rounding error of a chain of ten bones in single precision, with bones of up to ten metres.
    private static void AssertReference(
        float[] values, ChannelLayout layout, RotationOrder order, SkeletonBody body, BoneTransform[] world)
    {
        var rotations = new ReferenceRotation[59];
        double[][] positions = new double[59][];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            int index = layout.GetPositionIndex(bone);
            Vector3 offset = index < 0 ? body.GetOffset(bone) : MemoryMarshal.Cast<float, Vector3>(values.AsSpan(index, 3))[0];
            double[] position = [offset.X, offset.Y, offset.Z];
            var rotation = ReferenceRotation.FromAngles(MemoryMarshal.Cast<float, Vector3>(values.AsSpan(layout.GetRotationIndex(bone), 3))[0], order);
            if (BoneHierarchy.GetParent(bone, body.Variant) is { } parent)
            {
                double[] turned = rotations[(int)parent].Turn(position);
                position = [.. turned.Zip(positions[(int)parent], (one, other) => one + other)];
                rotation = rotations[(int)parent].Times(rotation);
            }

            (rotations[(int)bone], positions[(int)bone]) = (rotation, position);
            Vector3 found = world[(int)bone].Position;
            double error = new[] { found.X - position[0], found.Y - position[1], found.Z - position[2] }.Max(Math.Abs);
            Assert.True(error < 4e-3, $"{bone} is off by {error} cm.");
            Assert.True(rotation.Distance(world[(int)bone].Rotation) < 3e-6, $"{bone} is turned by {rotation.Distance(world[(int)bone].Rotation)}.");
        }
    }
}
