using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Delivery;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

/// <summary>When the queues of a reader show frames that arrived together.</summary>
public sealed class HeldFramesTests
{
    private const int Sent = 40;

    private readonly ReceivePipeline _pipeline = DeliveryBench.CreatePipeline();

    [Fact]
    public void A_queue_shows_the_frames_of_a_large_piece_together()
    {
        using FrameQueue queue = _pipeline.OpenQueue(8 * Sent, "held");
        List<int> counts = [];
        queue.Changed = () => counts.Add(queue.Count);
        Push(TestPackets.Motions(0, Sent));
        Assert.Equal([Sent], counts);

        queue.Pump<MotionFrame>(static _ => { });
        Push(TestPackets.Motion(Sent));
        Assert.Equal([Sent, 1], counts);
    }

    // The consumer can make room while the rest of the piece is read.
    [Theory]
    [InlineData(8, 1)]
    [InlineData(32, 4)]
    public void A_small_queue_shows_its_frames_before_it_is_full(int capacity, int together)
    {
        using FrameQueue queue = _pipeline.OpenQueue(capacity, "small");
        List<int> counts = [];
        queue.Changed = () => counts.Add(queue.Pump<MotionFrame>(static _ => { }));
        Push(TestPackets.Motions(0, Sent));
        Assert.Equal(Enumerable.Repeat(together, Sent / together), counts);
        Assert.Equal(0, queue.Dropped);
    }

    [Fact]
    public void Before_each_handler_the_queue_shows_all_earlier_frames()
    {
        using FrameQueue queue = _pipeline.OpenQueue(Sent, "not held");
        List<int> counts = [];
        _pipeline.Callbacks.Motion.Add(_ => counts.Add(queue.Count));
        Push(TestPackets.Motions(0, Sent));
        Assert.Equal(Enumerable.Range(0, Sent), counts);
    }

    [Fact]
    public void Before_the_handler_of_a_command_the_queue_shows_all_earlier_frames()
    {
        using FrameQueue queue = _pipeline.OpenQueue(Sent, "not held");
        List<int> counts = [];
        _pipeline.Commands.Received += _ => counts.Add(queue.Count);
        Push([.. TestPackets.Motions(0, 20), .. DataReplies.BoneSizes(), .. TestPackets.Motions(20, 5)]);
        Assert.Equal([20], counts);
        Assert.Equal(25, queue.Count);
    }

    [Fact]
    public async Task While_a_queue_waits_for_room_all_queues_show_their_frames()
    {
        using FrameQueue waiting = _pipeline.OpenQueue(new FrameQueueOptions { Capacity = 4, WhenFull = WhenFull.Wait });
        using FrameQueue other = _pipeline.OpenQueue(Sent, "other");
        Task pushing = Task.Run(() => Push(TestPackets.Motions(0, Sent)), TestContext.Current.CancellationToken);
        int taken = 0;
        while (taken < Sent)
        {
            int expected = Math.Min(taken + waiting.Capacity, Sent);
            await Limits.UntilAsync(() => other.Count >= expected && waiting.Count == expected - taken);
            taken += waiting.Pump<MotionFrame>(static _ => { }, maxFrames: waiting.Capacity);
        }

        await pushing.Soon();
        Assert.Equal((0L, 0L, Sent), (waiting.Dropped, other.Dropped, other.Count));
    }

    private void Push(byte[] bytes) => new PacketAssembler(new PacketScanner(), _pipeline).Push(new ArraySegment<byte>(bytes), timestamp: 1);
}
