using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

/// <summary>The same pose with other channels, names or sides.</summary>
public class BvhPoseTests
{
    // A float holds an angle to a hundred-thousandth of a degree.
    private const double SamePlace = 2e-3;
    private const double SameRotation = 1e-5;

    public static MatrixTheoryData<RotationOrder, RotationOrder> OrderPairs => new(Enum.GetValues<RotationOrder>(), Enum.GetValues<RotationOrder>());

    public static MatrixTheoryData<SkeletonVariant, bool, bool> Layouts => new(Enum.GetValues<SkeletonVariant>(), [false, true], [false, true]);

    [Fact]
    public void Changing_the_rotation_order_keeps_the_pose()
    {
        for (int seed = 0; seed < 60; seed++)
        {
            var random = new RandomTakes(seed);
            BvhDocument take = random.Take(random.TurningHierarchy(), 6);
            BvhDocument other = take.WithRotationOrder((RotationOrder)(seed % 6));

            AssertSamePoses(take, other);
            Assert.All(other.Joints, joint => Assert.Equal(((RotationOrder)(seed % 6)).ToString(), OrderOf(joint)));
        }
    }

    [Theory, MemberData(nameof(OrderPairs))]
    public void Every_conversion_of_orders_keeps_the_pose(RotationOrder from, RotationOrder to)
    {
        BvhDocument take = NeuronTake(new SkeletonFormat(from, SkeletonVariant.Neck1), default, frames: 8);
        BvhDocument other = take.WithRotationOrder(to);

        AssertSamePoses(take, other);
        Assert.True(BvhSkeletonMap.TryCreate(other, out BvhSkeletonMap? map, out string? reason), reason);
        Assert.Equal(to, map.Format.RotationOrder);
        if (from == to)
            AssertBits(Values(take), Values(other));
    }

    // If the second angle is 90 degrees, the first and the third turn about the same line.
    [Fact]
    public void Rotations_at_the_pole_keep_their_pose_without_jumps()
    {
        BvhHierarchy hierarchy = Parse("HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 3 Yrotation Xrotation Zrotation\n}\n").Hierarchy;
        float[] values = [.. Enumerable.Range(0, 181).SelectMany(static i => new[] { 20f, i, 30f })];
        var take = new BvhDocument(hierarchy, BvhFrameTime.Default, values);

        foreach (RotationOrder order in Enum.GetValues<RotationOrder>())
        {
            BvhDocument back = take.WithRotationOrder(order).WithRotationOrder(RotationOrder.YXZ);
            AssertSamePoses(take, back);
            Assert.True(LargestStep(back) < 1.01, $"{order}: {LargestStep(back)}");
        }
    }

    [Fact]
    public void A_NaN_row_does_not_affect_later_rows()
    {
        BvhHierarchy hierarchy = Parse("HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 3 Yrotation Xrotation Zrotation\n}\n").Hierarchy;
        var take = new BvhDocument(hierarchy, BvhFrameTime.Default, [1, 2, 3, float.NaN, 2, 3, 1, 2, 4]);

        BvhDocument other = take.WithRotationOrder(RotationOrder.XYZ);
        Assert.Equal(0, new RawPose(take, 2).Distance(new RawPose(other, 2)).Rotation, SameRotation);
    }

    [Fact]
    public void The_filter_removes_flips_and_keeps_the_pose()
    {
        var random = new RandomTakes(3);
        BvhDocument smooth = random.Take(BvhBoneHierarchy.Create(default, default), 50);
        float[] values = Values(smooth);
        for (int frame = 1; frame < 50; frame += 2)
            Flip(values.AsSpan(frame * 180, 180));

        BvhDocument filtered = new BvhDocument(smooth.Hierarchy, smooth.FrameTime, values).FilterEulerAngles();
        AssertSamePoses(smooth, filtered);
        Assert.True(LargestStep(filtered) < 30, $"{LargestStep(filtered)}");
        AssertBits(Values(filtered), Values(filtered.FilterEulerAngles()));
    }

    [Fact]
    public void Adding_and_removing_displacement_restores_the_take()
    {
        for (int seed = 0; seed < 60; seed++)
        {
            var random = new RandomTakes(seed);
            BvhDocument take = random.Take(random.TurningHierarchy(), 4).WithoutDisplacement(out _);
            BvhDocument displaced = take.WithDisplacement();
            AssertSamePoses(take, displaced, places: 0, rotations: 0);
            Assert.All(displaced.Joints, static joint => Assert.Equal(6, joint.Channels.Count));

            BvhDocument back = displaced.WithoutDisplacement(out PositionChannelLoss loss);
            Assert.Equal(default, loss);
            Assert.Equal(take.Joints.Select(static joint => joint.Offset).Skip(1), back.Joints.Select(static joint => joint.Offset).Skip(1));
            if (take.Joints[0].Channels.Count == 6)
                AssertBits(Values(take), Values(back));
        }
    }

    [Fact]
    public void The_loss_of_changing_displacement_is_reported()
    {
        BvhDocument take = Parse(
            """
            HIERARCHY
            ROOT A
            {
            OFFSET 0 0 0
            CHANNELS 3 Xposition Yposition Zposition
            JOINT B
            {
            OFFSET 1 0 0
            CHANNELS 4 Xposition Yposition Zposition Xrotation
            }
            }
            MOTION
            Frames: 3
            Frame Time: 0.01
            0 0 0 1 2 3 10
            0 0 0 1.1 2 3 20
            5 0 0 1.2 2 6 30

            """);

        BvhDocument without = take.WithoutDisplacement(out PositionChannelLoss loss);
        Assert.Equal("B", loss.Joint);
        Assert.Equal(2, loss.Frame);
        Assert.Equal(Math.Sqrt(9.01), loss.MaxError, 1e-6);
        Assert.Equal(new(1.1f, 2, 3), without.Joints[1].Offset);
        AssertBits([0, 0, 0, 10, 0, 0, 0, 20, 5, 0, 0, 30], Values(without));
    }

    [Theory, MemberData(nameof(Layouts))]
    public void Changing_the_variant_keeps_joint_positions(SkeletonVariant variant, bool displacement, bool reference)
    {
        SkeletonVariant other = variant == SkeletonVariant.Neck1 ? SkeletonVariant.Spine3 : SkeletonVariant.Neck1;
        BvhDocument take = NeuronTake(new SkeletonFormat(RotationOrder.YXZ, variant), new ChannelLayout(displacement, reference), frames: 6);
        BvhDocument changed = take.WithVariant(other);

        Assert.True(BvhSkeletonMap.TryCreate(changed, out BvhSkeletonMap? map, out string? reason), reason);
        Assert.Equal(other, map.Format.Variant);
        Assert.Equal(new ChannelLayout(hasDisplacement: true, reference), map.Layout);
        AssertSamePoses(take, changed, name => Rename(name, variant, other));
        AssertSamePoses(take, changed.WithVariant(variant));
        Assert.Same(take, take.WithVariant(variant));
    }

    [Fact]
    public void A_variant_needs_displacement_only_below_moving_bones()
    {
        BvhDocument take = NeuronTake(SkeletonFormat.Default, default, frames: 3);
        float[] values = Values(take);
        for (int frame = 0; frame < 3; frame++)
            values.AsSpan((frame * 180) + 3 + (3 * (int)Bone.Neck), 3).Clear();

        take = new BvhDocument(take.Hierarchy, take.FrameTime, values);
        BvhDocument changed = take.WithVariant(SkeletonVariant.Spine3);
        Assert.Equal(180, changed.ChannelCount);
        AssertSamePoses(take, changed, name => Rename(name, SkeletonVariant.Neck1, SkeletonVariant.Spine3));
    }

    [Fact]
    public void Another_skeleton_has_no_variant() => Assert.Throws<NeuronException>(() => Parse(TwoRows).WithVariant(SkeletonVariant.Spine3));

    private static BvhDocument NeuronTake(SkeletonFormat format, ChannelLayout layout, int frames)
    {
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(format, layout);
        return new RandomTakes((int)format.RotationOrder).Take(hierarchy, frames);
    }

    internal static string Rename(string name, SkeletonVariant from, SkeletonVariant to) =>
        BoneHierarchy.TryFind(name, from, out Bone bone) ? BoneHierarchy.GetName(bone, to) : name;

    private static string OrderOf(BvhJoint joint) =>
        string.Concat(joint.Channels.Where(static channel => channel >= BvhChannel.Xrotation).Select(static channel => channel.ToString()[0]));

    // Writes the other triple of the same rotation.
    private static void Flip(Span<float> row)
    {
        for (int i = 3; i < row.Length; i += 3)
            (row[i], row[i + 1], row[i + 2]) = (row[i] + 180, 180 - row[i + 1], row[i + 2] - 180);
    }

    private static float LargestStep(BvhDocument take) => Enumerable.Range(1, take.FrameCount - 1).Max(frame =>
        Enumerable.Range(0, take.ChannelCount).Max(column => Math.Abs(take.GetValues(frame)[column] - take.GetValues(frame - 1)[column])));

    private static void AssertSamePoses(
        BvhDocument expected, BvhDocument actual, Func<string, string>? rename = null, double places = SamePlace, double rotations = SameRotation)
    {
        Assert.Equal(expected.FrameCount, actual.FrameCount);
        for (int frame = 0; frame < expected.FrameCount; frame++)
            AssertNear(new RawPose(expected, frame).Distance(new RawPose(actual, frame), rename), places, rotations);
    }

    internal static void AssertNear((double Position, double Rotation) distance, double places = SamePlace, double rotations = SameRotation)
    {
        Assert.True(distance.Position <= places, $"A joint moved by {distance.Position}.");
        Assert.True(distance.Rotation <= rotations, $"A joint turned by {distance.Rotation}.");
    }
}
