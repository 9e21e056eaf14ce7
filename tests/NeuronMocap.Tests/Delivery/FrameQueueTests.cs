using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class FrameQueueTests
{
    private readonly FrameQueue _queue = new(4, SkeletonFormat.Default, _ => { });

    [Fact]
    public void Motion_and_calculation_frames_reach_their_handlers_in_order_of_arrival()
    {
        Publish(PacketKind.Motion, TestPackets.Motion(1));
        Publish(PacketKind.Calculation, TestPackets.Calculation(2));
        Publish(PacketKind.Motion, TestPackets.Motion(3));

        List<string> seen = [];
        int taken = _queue.Pump<AvatarFrame>(frame => seen.Add(frame is MotionFrame
            ? $"motion {frame.FrameIndex} {frame.Values[5]}"
            : $"calculation {frame.FrameIndex} {frame.Values.Length}"));

        Assert.Equal(3, taken);
        Assert.Equal([$"motion 1 {TestPackets.Value(1, 0, 5)}", "calculation 2 946", $"motion 3 {TestPackets.Value(3, 0, 5)}"], seen);
        Assert.Equal(0, _queue.Pump<MotionFrame>(_ => Assert.Fail("there was a frame")));
    }

    [Fact]
    public void Frames_of_other_kinds_are_skipped()
    {
        Publish(PacketKind.Calculation, TestPackets.Calculation(1));
        Publish(PacketKind.Motion, TestPackets.Motion(2));
        int frames = 0;
        Assert.Equal(2, _queue.Pump<MotionFrame>(_ => frames++));
        Assert.Equal(1, frames);
    }

    [Fact]
    public void A_full_queue_drops_the_newest_and_counts_them()
    {
        for (int i = 0; i < 7; i++)
            Publish(PacketKind.Motion, TestPackets.Motion(i));

        List<uint?> indices = [];
        _queue.Pump<MotionFrame>(frame => indices.Add(frame.FrameIndex));
        Assert.Equal([0u, 1u, 2u, 3u], indices);
        Assert.Equal(3, _queue.Dropped);
    }

    [Fact]
    public void A_limited_pump_leaves_the_rest()
    {
        for (int i = 0; i < 4; i++)
            Publish(PacketKind.Motion, TestPackets.Motion(i));

        Assert.Equal(3, _queue.Pump<MotionFrame>(_ => { }, maxFrames: 3));
        Assert.Equal(1, _queue.Count);
        Assert.Equal(0, _queue.Pump<MotionFrame>(_ => { }, maxFrames: 0));
        Assert.Equal(1, _queue.Pump<MotionFrame>(_ => { }));
    }

    [Fact]
    public void A_handler_exception_is_rethrown_and_its_frame_is_consumed()
    {
        Publish(PacketKind.Motion, TestPackets.Motion(1));
        Publish(PacketKind.Motion, TestPackets.Motion(2));
        Assert.Throws<FormatException>(() => _queue.Pump<MotionFrame>(_ => throw new FormatException()));

        List<uint?> indices = [];
        _queue.Pump<MotionFrame>(frame => indices.Add(frame.FrameIndex));
        Assert.Equal([2u], indices);
    }

    [Fact]
    public void A_handler_cannot_pump_the_queue_it_is_called_from()
    {
        Publish(PacketKind.Motion, TestPackets.Motion(1));
        _queue.Pump<MotionFrame>(_ => Assert.Throws<InvalidOperationException>(() => _queue.Pump<MotionFrame>(_ => { })));
        Assert.Equal(0, _queue.Pump<MotionFrame>(_ => { }));
    }

    [Fact]
    public void Disposing_ends_a_pump_after_the_running_handler()
    {
        int closed = 0;
        var queue = new FrameQueue(4, SkeletonFormat.Default, _ => closed++);
        for (int i = 0; i < 3; i++)
            ((IPacketConsumer)queue).OnPacket(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(i), 0, 0));

        Assert.Equal(1, queue.Pump<MotionFrame>(_ => queue.Dispose()));
        queue.Dispose();
        Assert.Equal(1, closed);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData((1 << 20) + 1)]
    public void A_capacity_out_of_range_is_refused(int capacity) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new FrameQueue(capacity, SkeletonFormat.Default, _ => { }));

    private void Publish(PacketKind kind, byte[] packet) => ((IPacketConsumer)_queue).OnPacket(new ReceivedPacket(kind, packet, 0, 0));
}
