namespace NeuronMocap.Tests.Delivery;

/// <summary>Windows, deliveries and readers that close in every order.</summary>
public sealed class ClosedWindowTests
{
    public static TheoryData<string> Orders => ["delivery reader window", "delivery window reader", "reader delivery window", "reader window delivery", "window delivery reader", "window reader delivery"];

    [Theory, MemberData(nameof(Orders))]
    public async Task Closing_on_the_windows_thread_with_a_post_outstanding(string order)
    {
        await using var scene = await Scene.StartAsync();
        await scene.SendAsync(0, 3);

        // On a busy machine, the timer posts the rest of the frames.
        await Limits.UntilAsync(() => scene.Delivery.Delivered == 3);
        scene.Window.Drain();
        int before = scene.Seen.Count;
        using (scene.BlockWindow())
        {
            await scene.SendAsync(3, 3);
            scene.Window.Post(
                _ =>
                {
                    before = scene.Seen.Count;
                    foreach (string part in order.Split(' '))
                        Close(scene, part);
                },
                state: null);
        }

        await scene.Reader.Completion.Soon();
        await Limits.UntilAsync(() => scene.Delivery.End is not null && !scene.Window.Thread.IsAlive);

        // On a busy machine, a run can reach its limit of time before the last frame.
        Assert.InRange(before, 4, 6);
        Assert.Equal(before, scene.Seen.Count);
        Assert.Empty(scene.Window.Exceptions);
    }

    [Theory, MemberData(nameof(Orders))]
    public async Task Closing_on_another_thread_while_a_handler_runs(string order)
    {
        await using var scene = await Scene.StartAsync();
        using var entered = new ManualResetEventSlim();
        using var released = new ManualResetEventSlim();
        scene.Delivery.MotionReceived += _ =>
        {
            entered.Set();
            released.Wait(Limits.Unexpected);
        };
        await scene.SendAsync(0, 3);
        entered.Wait(Limits.Unexpected, TestContext.Current.CancellationToken);
        scene.Window.KeepThread();
        foreach (string part in order.Split(' '))
            Close(scene, part);

        // The handler still runs, so nothing waited for it.
        await scene.Reader.Completion.Soon();
        Assert.NotNull(scene.Delivery.End);
        Assert.Equal([0u], scene.Seen);
        released.Set();
        scene.Window.Dispose();
        Assert.Equal([0u], scene.Seen);
    }

    [Theory]
    [InlineData("delivery")]
    [InlineData("reader")]
    [InlineData("delivery reader")]
    [InlineData("reader delivery")]
    [InlineData("window reader")]
    public async Task Closing_in_a_handler(string order)
    {
        await using var scene = await Scene.StartAsync();
        int after = 0;
        scene.Delivery.MotionReceived += _ =>
        {
            foreach (string part in order.Split(' '))
                Close(scene, part);
        };
        scene.Delivery.MotionReceived += _ => after++;
        scene.Delivery.StatusChanged += status => after += status.State == ConnectionState.Stopped ? 1 : 0;
        using (scene.BlockWindow())
            await scene.SendAsync(0, 10);

        await scene.Delivery.Completion.Soon();
        if (!order.Contains("window", StringComparison.Ordinal))
            scene.Window.Drain();
        scene.Reader.Dispose();
        Assert.Equal((1, 0), (scene.Seen.Count, after));
        Assert.Empty(scene.Window.Exceptions);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task The_reader_ends_asynchronously_on_the_windows_thread(bool isBlocking)
    {
        await using var scene = await Scene.StartAsync();
        using (scene.BlockWindow())
            await scene.SendAsync(0, 5);

        int before = 0;
        Task<bool> closing = scene.Window.Invoke(async () =>
        {
            Task disposing = scene.Reader.DisposeAsync().AsTask();
            before = scene.Seen.Count;
            if (isBlocking)
                Assert.True(disposing.Wait(Limits.Unexpected));
            else
                await disposing;

            return scene.Window.IsCurrent;
        });
        Assert.True(await closing.Soon());
        scene.Window.Drain();
        Assert.Equal(before, scene.Seen.Count);
        Assert.Equal(FrameDeliveryEndReason.ReaderStopped, scene.Delivery.End?.Reason);
    }

    [Fact]
    public async Task A_window_whose_context_throws_ends_its_delivery_only()
    {
        await using var scene = await Scene.StartAsync();
        using FrameQueue queue = scene.Reader.OpenQueue();
        await scene.SendAsync(0, 3);

        // A post of the timer, for the rest of the frames, could be lost with the loop.
        await Limits.UntilAsync(() => scene.Delivery.Delivered == 3);
        scene.Window.Drain();
        scene.Window.End();
        await scene.SendAsync(3, 3);
        FrameDeliveryEnd end = await scene.Delivery.Completion.Soon();
        Assert.Equal(FrameDeliveryEndReason.ContextGone, end.Reason);
        Assert.IsType<InvalidOperationException>(end.Exception);
        Assert.Equal((6, 0L, ConnectionState.Receiving), (queue.Count, scene.Reader.GetStatistics().CallbackFailures, scene.Reader.Status.State));
    }

    [Theory]
    [InlineData(FrameDeliveryMode.EveryFrame, true)]
    [InlineData(FrameDeliveryMode.EveryFrame, false)]
    [InlineData(FrameDeliveryMode.Newest, true)]
    public async Task A_dead_thread_tells_that_a_context_ignores_posts(FrameDeliveryMode mode, bool hasRun)
    {
        var clock = new FakeDeliveryClock();
        await using var scene = await Scene.StartAsync(new FrameDeliveryOptions { Mode = mode }, latePost: LatePost.Ignore, clock: clock);
        if (hasRun)
        {
            await scene.SendAsync(0, 1);
            scene.Window.Drain();
        }

        // A post may be lost with the loop, or be ignored later.
        scene.Window.End();
        await scene.SendAsync(1, 100);
        Assert.Null(scene.Delivery.End);
        clock.Advance(5_000);
        await scene.SendAsync(101, 200);
        clock.Advance(5_000);
        Assert.Equal((FrameDeliveryEndReason.ContextGone, null), (scene.Delivery.End?.Reason, scene.Delivery.End?.Exception));
        await scene.SendAsync(301, 100);
    }

    [Fact]
    public async Task The_end_of_the_reader_tells_that_the_window_is_gone()
    {
        var clock = new FakeDeliveryClock();
        await using var scene = await Scene.StartAsync(latePost: LatePost.Ignore, clock: clock);
        await scene.SendAsync(0, 1);
        scene.Window.Drain();
        scene.Window.End();
        scene.Connection.Close();
        await scene.Reader.Completion.Soon();
        Assert.Null(scene.Delivery.End);
        clock.Advance(5_000);
        Assert.Equal(FrameDeliveryEndReason.ContextGone, scene.Delivery.End?.Reason);
    }

    [Fact]
    public async Task A_loop_that_ends_before_its_thread_only_drops_frames()
    {
        await using var scene = await Scene.StartAsync(new FrameDeliveryOptions { Capacity = 16 }, latePost: LatePost.Ignore);
        scene.Window.KeepThread();
        scene.Window.End();
        await scene.SendAsync(0, 100);
        Assert.Null(scene.Delivery.End);
        Assert.Equal(100, scene.Delivery.Delivered + scene.Delivery.Dropped + scene.Delivery.Pending);
        scene.Reader.Dispose();
        Assert.Equal(FrameDeliveryEndReason.ReaderStopped, scene.Delivery.End?.Reason);
    }

    [Fact]
    public async Task A_window_can_move_to_another_thread()
    {
        var clock = new FakeDeliveryClock();
        var first = new MessageLoop();
        using var second = new MessageLoop();
        MessageLoop current = first;
        await using var scene = await Scene.StartAsync(
            new FrameDeliveryOptions
            {
                Post = action =>
                {
                    current.Post(static action => ((Action)action!)(), action);
                    return true;
                },
            },
            clock: clock);
        await scene.SendAsync(0, 1);
        await Limits.UntilAsync(() => scene.Delivery.Delivered == 1);
        first.Drain();
        current = second;
        first.Dispose();
        await scene.SendAsync(1, 1);
        await Limits.UntilAsync(() => scene.Delivery.Delivered == 2);
        second.Drain();
        clock.Advance(5_000);
        await scene.SendAsync(2, 1);
        await Limits.UntilAsync(() => scene.Delivery.Delivered == 3);
        Assert.Null(scene.Delivery.End);
    }

    private static void Close(Scene scene, string part)
    {
        switch (part)
        {
            case "delivery":
                scene.Delivery.Dispose();
                scene.Delivery.Dispose();
                break;
            case "reader":
                scene.Reader.Dispose();
                scene.Reader.Dispose();
                break;
            default:
                scene.Window.End();
                break;
        }
    }
}
