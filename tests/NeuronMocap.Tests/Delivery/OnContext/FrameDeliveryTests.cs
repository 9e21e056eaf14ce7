using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class FrameDeliveryTests
{
    [Fact]
    public void Handlers_run_on_the_context_and_nowhere_else()
    {
        var bench = new DeliveryBench();
        bench.PushMany(0, 3);
        bench.Report(ConnectionState.Receiving);
        Assert.Empty(bench.Seen);

        bench.Context.RunAll();
        Assert.Equal([0u, 1u, 2u], bench.Indices);
    }

    [Fact]
    public void At_most_one_post_is_outstanding_however_many_frames_arrive()
    {
        var bench = new DeliveryBench();
        for (int i = 0; i < 10; i++)
        {
            bench.PushMany(i * 100, 100);
            bench.Report(ConnectionState.Receiving);
            Assert.Equal((1, i + 1), (bench.Context.Waiting, bench.Context.Posts));
            bench.Context.RunOne();
        }

        Assert.Equal((0, 1, 1000), (bench.Context.Waiting, bench.Context.MostWaiting, bench.Seen.Count));
    }

    [Fact]
    public void All_kinds_of_frames_arrive_in_order()
    {
        var bench = new DeliveryBench();
        List<string> seen = [];
        bench.Delivery.MotionReceived += frame => seen.Add($"motion {frame.FrameIndex}");
        bench.Delivery.CalculationReceived += frame => seen.Add($"calculation {frame.FrameIndex}");
        bench.Delivery.StudioCalculationReceived += frame => seen.Add($"studio {frame.FrameIndex}");
        bench.Push(1);
        bench.Push(PacketKind.Calculation, TestPackets.Calculation(2));
        bench.Push(PacketKind.StudioCalculation, TestPackets.Studio(3));
        bench.Push(4);
        bench.Context.RunAll();
        Assert.Equal(["motion 1", "calculation 2", "studio 3", "motion 4"], seen);
    }

    [Fact]
    public void A_frame_is_valid_until_its_handler_returns()
    {
        var bench = new DeliveryBench();
        List<MotionFrame> kept = [];
        bench.Delivery.MotionReceived += kept.Add;
        bench.Delivery.MotionReceived += static frame =>
        {
            if (frame.FrameIndex == 1)
                throw new FormatException();
        };
        bench.PushMany(0, 2);
        Assert.Throws<FormatException>(bench.Context.RunAll);
        Assert.Equal(2, kept.Count);
        Assert.All(kept, static frame => Assert.Throws<InvalidOperationException>(() => frame.FrameIndex));
    }

    [Theory]
    [InlineData(FrameDeliveryMode.EveryFrame)]
    [InlineData(FrameDeliveryMode.Newest)]
    public void A_full_backlog_is_bounded_and_every_frame_is_counted(FrameDeliveryMode mode)
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = mode, Capacity = 4 });
        for (int round = 0; round < 5; round++)
        {
            for (int i = 0; i < 6; i++)
                bench.Push((round * 10) + i, avatar: i % 2);
            bench.AssertSumsAddUp();
            bench.Context.RunAll();
            bench.AssertSumsAddUp();
        }

        bool isEvery = mode == FrameDeliveryMode.EveryFrame;
        Assert.Equal((isEvery ? 20 : 10, isEvery ? 10 : 0, isEvery ? 0 : 20), (bench.Delivery.Delivered, bench.Delivery.Dropped, bench.Delivery.Replaced));
        Assert.Equal((uint?)(isEvery ? 43u : 45u), bench.Seen[^1].Index);
        Assert.Equal(bench.Delivery.Dropped, bench.Statistics.Dropped);
    }

    [Fact]
    public void Drops_stay_in_the_statistics_of_the_reader_after_the_end()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Capacity = 2, Name = "window" });
        bench.PushMany(0, 5);
        bench.Delivery.Dispose();
        bench.PushMany(5, 5);
        Assert.Equal((3, 3, 2), (bench.Delivery.Dropped, bench.Statistics.Dropped, bench.Delivery.Pending));
        ConsumerStatistics consumer = Assert.Single(bench.Pipeline.GetConsumers());
        Assert.Equal(("window", 3, 0), (consumer.Name, consumer.Dropped, consumer.Waiting));
    }

    [Theory]
    [InlineData(FrameDeliveryMode.EveryFrame)]
    [InlineData(FrameDeliveryMode.Newest)]
    public void Delivering_a_frame_allocates_nothing(FrameDeliveryMode mode)
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = mode, MaxRate = mode == FrameDeliveryMode.Newest ? 500 : 0 });
        float sum = 0;
        long frames = 0;
        bench.Seen.Capacity = 20_000;
        bench.Delivery.MotionReceived += frame =>
        {
            sum += frame.Values[5];
            frames++;
        };
        byte[] packet = TestPackets.Motion(1);
        IPacketConsumer consumer = bench.Delivery;
        Allocations.AssertNone(() =>
        {
            consumer.OnPacket(new ReceivedPacket(PacketKind.Motion, packet, bench.Clock.Now, 0));
            bench.Clock.Advance(8);
            bench.Context.RunAll();
        });
        Assert.True(frames >= 150, $"{frames} frames");
        Assert.NotEqual(0, sum);
    }

    [Fact]
    public void A_change_of_status_arrives_on_the_context_before_frames_that_wait()
    {
        var bench = new DeliveryBench();
        List<string> seen = [];
        bench.Delivery.MotionReceived += frame => seen.Add($"{frame.FrameIndex}");
        bench.Delivery.StatusChanged += status => seen.Add(status.Message);
        bench.Push(1);
        bench.Report(ConnectionState.Connected);
        bench.Report(ConnectionState.Receiving);
        Assert.Empty(seen);
        bench.Context.RunAll();
        Assert.Equal(["Connected", "Receiving", "1"], seen);
    }

    [Fact]
    public void The_end_of_the_reader_follows_the_last_frame()
    {
        var bench = new DeliveryBench();
        List<string> seen = [];
        bench.Delivery.MotionReceived += frame =>
        {
            seen.Add($"{frame.FrameIndex}");
            bench.Clock.Advance(3);
        };
        bench.Delivery.StatusChanged += status => seen.Add(status.Message);
        bench.PushMany(0, 3);
        bench.Report(ConnectionState.Stopped);
        while (bench.Delivery.End is null)
        {
            bench.Context.RunAll();
            bench.Clock.Advance(10);
        }

        Assert.Equal(["0", "1", "2", "Stopped"], seen);
        Assert.Equal(FrameDeliveryEndReason.ReaderStopped, bench.End.Reason);
        Assert.Equal((1, true), (bench.Closed, bench.Clock.IsDisposed));
    }

    // The window runs while the reader reports its end.
    [Fact]
    public async Task The_end_of_the_reader_follows_the_last_frame_of_a_window_that_runs_meanwhile()
    {
        for (int i = 0; i < 2_000; i++)
        {
            var bench = new DeliveryBench();
            List<string> seen = [];
            bench.Delivery.MotionReceived += frame => seen.Add($"{frame.FrameIndex}");
            bench.Delivery.StatusChanged += status => seen.Add(status.Message);
            Task window = Task.Run(
                () =>
                {
                    while (bench.Delivery.End is null)
                        bench.Context.RunAll();
                },
                TestContext.Current.CancellationToken);
            bench.Push(0);
            bench.Report(ConnectionState.Stopped);
            await window.Soon();
            Assert.Equal(["0", "Stopped"], seen);
        }
    }

    [Fact]
    public void A_busy_context_gets_the_newest_changes_of_status()
    {
        var bench = new DeliveryBench();
        List<string> seen = [];
        bench.Delivery.StatusChanged += status => seen.Add(status.Message);
        for (int i = 0; i < 100; i++)
            bench.Delivery.OnStatus(new ConnectionStatus(ConnectionState.Waiting, ConnectionReason.Refused, $"{i}"));

        bench.Context.RunAll();
        Assert.Equal(Enumerable.Range(36, 64).Select(static i => $"{i}"), seen);
    }

    [Fact]
    public void Handlers_can_be_removed()
    {
        var bench = new DeliveryBench();
        int frames = 0;
        bench.Delivery.MotionReceived += Count;
        bench.Push(1);
        bench.Context.RunAll();
        bench.Delivery.MotionReceived -= Count;
        bench.Push(2);
        bench.Context.RunAll();
        Assert.Equal((1, 2), (frames, bench.Seen.Count));

        void Count(MotionFrame frame) => frames++;
    }
}
