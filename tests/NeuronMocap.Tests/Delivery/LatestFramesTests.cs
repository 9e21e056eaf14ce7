using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class LatestFramesTests
{
    private readonly LatestFrames _latest = new(SkeletonFormat.Default, _ => { });

    [Fact]
    public void An_unknown_avatar_has_no_frame()
    {
        Assert.False(_latest.TryTakeMotion(0, out MotionFrame? motion));
        Assert.Null(motion);
        Assert.False(_latest.TryTakeMotion(-1, out _));
        Assert.False(_latest.TryTakeMotion(LatestFrames.MaxAvatars, out _));
        Assert.False(_latest.TryTakeCalculation(0, out _));
    }

    [Fact]
    public void Each_avatar_keeps_its_own_newest_frame_of_each_kind()
    {
        Publish(PacketKind.Motion, TestPackets.Motion(1, avatar: 0));
        Publish(PacketKind.Motion, TestPackets.Motion(2, avatar: 3));
        Publish(PacketKind.Motion, TestPackets.Motion(4, avatar: 0));
        Publish(PacketKind.Calculation, TestPackets.Calculation(9, avatar: 3));

        Assert.True(_latest.TryTakeMotion(0, out MotionFrame? first));
        Assert.Equal(4u, first.FrameIndex);
        Assert.True(_latest.TryTakeMotion(3, out MotionFrame? second));
        Assert.Equal(TestPackets.Value(2, 3, 17), second.Values[17]);
        Assert.True(_latest.TryTakeCalculation(3, out CalculationFrame? calculation));
        Assert.Equal(9u, calculation.FrameIndex);
        Assert.False(_latest.TryTakeCalculation(0, out _));
    }

    [Fact]
    public void A_taken_frame_is_returned_again_but_not_as_new()
    {
        Publish(PacketKind.Motion, TestPackets.Motion(1));
        Assert.True(_latest.TryTakeMotion(0, out MotionFrame? taken));
        Assert.False(_latest.TryTakeMotion(0, out MotionFrame? again));
        Assert.Same(taken, again);

        Publish(PacketKind.Motion, TestPackets.Motion(2));
        Assert.Equal(1u, taken.FrameIndex);
        Assert.True(_latest.TryTakeMotion(0, out again));
        Assert.Equal(2u, again.FrameIndex);
    }

    [Fact]
    public void An_avatar_number_beyond_the_table_is_ignored()
    {
        Publish(PacketKind.Motion, TestPackets.Motion(1, avatar: LatestFrames.MaxAvatars));
        Publish(PacketKind.Motion, TestPackets.Motion(1, avatar: -1));
        Publish(PacketKind.Motion, TestPackets.Motion(1, avatar: LatestFrames.MaxAvatars - 1));
        Assert.True(_latest.TryTakeMotion(LatestFrames.MaxAvatars - 1, out _));
    }

    private void Publish(PacketKind kind, byte[] packet) => ((IPacketConsumer)_latest).OnPacket(new ReceivedPacket(kind, packet, 0, 0));
}
