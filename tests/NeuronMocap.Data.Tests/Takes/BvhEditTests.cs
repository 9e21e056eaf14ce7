using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Data.Tests.Takes;

// A recorded take that is written, mirrored and turned.
public sealed class BvhEditTests
{
    [Fact]
    public void A_recorded_take_has_axis_neurons_layout() => Assert.Equal(
        BvhTextFormat.AxisNeuron with { FrameTimeText = "0.008" },
        BvhDocument.Load(Fixtures.Require("test-take", "test.bvh")).TextFormat);

    [Fact]
    public void Mirroring_a_recorded_take_twice_restores_it_bit_for_bit()
    {
        BvhDocument take = BvhDocument.Load(Fixtures.Require("test-take", "test.bvh"));
        BvhDocument mirrored = take.Mirror();

        BvhMirrorTests.AssertMirrored(take.Trim(700, 1), mirrored.Trim(700, 1), BvhMirrorTests.OtherSide);
        Assert.Equal(NamesOf(take), NamesOf(mirrored));
        AssertBits(Values(take), Values(mirrored.Mirror()));
        Assert.Equal(BvhWriterTests.Saved(take), BvhWriterTests.Saved(mirrored.Mirror()));
    }

    [Fact]
    public void A_recorded_take_keeps_its_pose_in_the_other_variant_and_in_every_order()
    {
        BvhDocument take = BvhDocument.Load(Fixtures.Require("test-take", "test.bvh"));
        BvhDocument changed = take.WithVariant(SkeletonVariant.Neck1);
        for (int frame = 0; frame < take.FrameCount; frame += 97)
            BvhPoseTests.AssertNear(new RawPose(take, frame).Distance(new RawPose(changed, frame), name => BvhPoseTests.Rename(name, SkeletonVariant.Spine3, SkeletonVariant.Neck1)));

        foreach (RotationOrder order in Enum.GetValues<RotationOrder>())
        {
            BvhDocument other = take.WithRotationOrder(order);
            for (int frame = 0; frame < take.FrameCount; frame += 331)
                BvhPoseTests.AssertNear(new RawPose(take, frame).Distance(new RawPose(other, frame)));
        }
    }

    [Fact]
    public void A_recorded_take_is_written_byte_for_byte()
    {
        string path = Fixtures.Require("test-take", "test.bvh");
        Assert.True(File.ReadAllBytes(path).AsSpan().SequenceEqual(BvhWriterTests.Saved(BvhDocument.Load(path))), "The file differs.");
    }
}
