using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

/// <summary>How often and how long a delivery uses the context's thread.</summary>
public sealed class DeliveryPaceTests
{
    private const double Interval = 1000.0 / 120;

    [Fact]
    public void The_newest_frame_of_each_avatar_and_kind_is_delivered()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest });
        uint? calculation = null;
        bench.Delivery.CalculationReceived += frame => calculation = frame.FrameIndex;
        bench.Push(1, avatar: 3);
        bench.Push(2, avatar: 0);
        bench.Push(PacketKind.Calculation, TestPackets.Calculation(3));
        bench.Push(4, avatar: 3);
        bench.Context.RunAll();
        Assert.Equal([(3, 4u), (0, 2u)], bench.Seen.Select(static frame => (frame.Avatar, frame.Index!.Value)));
        Assert.Equal(3u, calculation);

        bench.Context.RunAll();
        Assert.Equal(2, bench.Seen.Count);
    }

    [Fact]
    public void Avatar_numbers_beyond_the_table_are_counted_as_dropped()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest });
        bench.Push(1, avatar: LatestFrames.MaxAvatars);
        bench.Push(2, avatar: -1);
        bench.Push(3, avatar: LatestFrames.MaxAvatars - 1);
        bench.Context.RunAll();
        Assert.Equal((1, 2), (bench.Delivery.Delivered, bench.Delivery.Dropped));
        bench.AssertSumsAddUp();
    }

    [Theory]
    [InlineData(30, 0)]
    [InlineData(60, 0)]
    [InlineData(60, 3)]
    [InlineData(50, 2)]
    [InlineData(100, 0)]
    public void Each_avatar_gets_at_most_the_requested_rate_and_on_average_that_rate(double rate, double jitter)
    {
        const int Seconds = 10;
        var random = new Random(1);
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest, MaxRate = rate });
        for (int i = 0; i < 120 * Seconds; i++)
        {
            double late = random.NextDouble() * jitter;
            bench.Clock.Advance(late);
            bench.Push(i, avatar: 0);
            bench.Push(i, avatar: 1);
            bench.Context.RunAll();
            bench.Clock.Advance(Interval - late);
            bench.Context.RunAll();
        }

        foreach (IGrouping<int, (int Avatar, uint? Index)> avatar in bench.Seen.GroupBy(static frame => frame.Avatar))
            Assert.InRange(avatar.Count(), (rate * Seconds * 0.98) - 1, (rate * Seconds) + 1);

        Assert.Equal(2, bench.Seen.DistinctBy(static frame => frame.Avatar).Count());
        bench.AssertSumsAddUp();
    }

    [Fact]
    public void Every_frame_at_a_rate_takes_every_second_frame_and_posts_for_no_other()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { MaxRate = 60 });
        for (int i = 0; i < 120; i++)
        {
            bench.Push(i);
            bench.Context.RunAll();
            bench.Clock.Advance(Interval);
        }

        Assert.Equal(Enumerable.Range(0, 60).Select(static i => (uint?)(2 * i)), bench.Indices);
        Assert.Equal((60, 60), (bench.Delivery.Skipped, bench.Context.Posts));
        bench.AssertSumsAddUp();
    }

    [Fact]
    public void A_full_queue_that_drops_its_oldest_delivers_the_newest()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Capacity = 4, WhenFull = WhenFull.DropOldest });
        bench.PushMany(0, 10);
        bench.Context.RunAll();
        Assert.Equal([6u, 7u, 8u, 9u], bench.Indices);
        Assert.Equal(6, bench.Delivery.Dropped);
        bench.AssertSumsAddUp();
    }

    [Fact]
    public void A_wait_for_the_rate_counts_as_a_pause()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest, MaxRate = 50 });
        bench.Delivery.MotionReceived += _ => bench.Clock.Advance(1);
        for (int i = 0; i < 100; i++)
        {
            bench.Push(i, avatar: 0);
            bench.Push(i, avatar: 1);
            bench.Context.RunAll();
            bench.Push(i, avatar: 0);
            bench.Push(i, avatar: 1);
            bench.Clock.Advance(20);
            bench.Context.RunAll();
        }

        // Two avatars take 2 ms, so each pass needs only one run.
        Assert.InRange(bench.Seen.Count, 200, 400);
        Assert.InRange(bench.Context.Posts, bench.Seen.Count / 2, (bench.Seen.Count / 2) + 2);
    }

    [Fact]
    public void A_stream_that_stops_ends_with_its_newest_frame()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest, MaxRate = 10 });
        bench.PushMany(0, 1);
        bench.Context.RunAll();
        bench.Clock.Advance(Interval);
        bench.PushMany(1, 2);
        bench.Context.RunAll();
        Assert.Equal([0u], bench.Indices);

        bench.Clock.Advance(100);
        bench.Context.RunAll();
        Assert.Equal([0u, 2u], bench.Indices);
        Assert.Equal(0, bench.Delivery.Pending);
    }

    [Fact]
    public void A_change_of_status_does_not_wait_for_the_rate()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest, MaxRate = 10 });
        List<ConnectionState> states = [];
        bench.Delivery.StatusChanged += status => states.Add(status.State);
        bench.Push(0);
        bench.Context.RunAll();
        bench.Push(1);
        bench.Context.RunAll();
        bench.Report(ConnectionState.Silent);
        bench.Context.RunAll();
        Assert.Equal([ConnectionState.Silent], states);
        Assert.Equal([0u], bench.Indices);
    }

    [Fact]
    public void An_idle_delivery_does_not_use_the_context()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest, MaxRate = 10 });
        bench.Push(0);
        bench.Context.RunAll();
        bench.Clock.Advance(100);
        bench.Context.RunAll();
        int posts = bench.Context.Posts;
        for (int i = 0; i < 100; i++)
        {
            bench.Clock.Advance(100);
            bench.Context.RunAll();
        }

        Assert.Equal(posts, bench.Context.Posts);
        Assert.Null(bench.Clock.Due);
    }

    // A context of Windows Forms runs all posts that arrive during a post before it looks at other messages.
    [Fact]
    public void A_burst_leaves_the_thread_to_other_messages()
    {
        var bench = new DeliveryBench();
        bench.Delivery.MotionReceived += _ => bench.Clock.Advance(1);
        bench.PushMany(0, 100);
        bench.Context.RunAll();
        Assert.InRange(bench.Seen.Count, 1, 5);

        int rounds = 0;
        while (bench.Seen.Count < 100)
        {
            bench.Clock.Advance(1);
            bench.Context.RunAll();
            rounds++;
            Assert.InRange(bench.Delivery.Pending, 0, 100 - (4 * Math.Min(rounds, 25)) + 5);
        }

        Assert.InRange(rounds, 19, 26);
        Assert.Equal(Enumerable.Range(0, 100).Select(static i => (uint?)i), bench.Indices);
    }

    [Fact]
    public void A_message_that_a_handler_posts_runs_before_the_end_of_the_burst()
    {
        var bench = new DeliveryBench();
        int seenBefore = 0;
        bench.Delivery.MotionReceived += frame =>
        {
            bench.Clock.Advance(1);
            if (frame.FrameIndex == 2)
                bench.Context.Post(_ => seenBefore = bench.Seen.Count, state: null);
        };
        bench.PushMany(0, 50);
        while (bench.Delivery.Pending > 0)
        {
            if (bench.Context.Waiting > 0)
                bench.Context.RunOne();
            else
                bench.Clock.Advance(1);
        }

        Assert.InRange(seenBefore, 3, 5);
    }

    [Fact]
    public void Arriving_frames_end_the_pause_when_the_timer_is_late()
    {
        var bench = new DeliveryBench();
        bench.Delivery.MotionReceived += frame =>
        {
            if (frame.FrameIndex == 0)
                bench.Clock.Advance(20);
        };
        bench.PushMany(0, 2);
        bench.Context.RunAll();
        Assert.Equal([0u], bench.Indices);
        bench.Push(2);
        Assert.Equal(0, bench.Context.Waiting);
        bench.Clock.AdvanceWithoutTimer(5);
        bench.Push(3);
        Assert.Equal(1, bench.Context.Waiting);
        bench.Context.RunAll();
        Assert.Equal([0u, 1u, 2u, 3u], bench.Indices);
    }

    [Fact]
    public void A_long_handler_does_not_delay_the_next_frames_for_long()
    {
        var bench = new DeliveryBench();
        bench.Delivery.MotionReceived += _ => bench.Clock.Advance(60_000);
        bench.PushMany(0, 2);
        bench.Context.RunAll();
        bench.Clock.Advance(8);
        bench.Context.RunAll();
        Assert.Equal([0u, 1u], bench.Indices);
    }
}
