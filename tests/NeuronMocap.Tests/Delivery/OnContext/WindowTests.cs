using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

/// <summary>A window's thread, a reader and a server.</summary>
public sealed class WindowTests
{
    [Fact]
    public async Task Every_frame_and_status_arrives_in_order_on_the_windows_thread_only()
    {
        using var server = new TestServer();
        using var window = new MessageLoop();
        await using var reader = new NeuronReader(server.Options());
        List<uint?> frames = [];
        List<ConnectionState> states = [];
        int elsewhere = 0;
        FrameDelivery delivery = window.Invoke(() => reader.OpenDelivery());
        delivery.MotionReceived += frame =>
        {
            frames.Add(frame.FrameIndex);
            elsewhere += window.IsCurrent ? 0 : 1;
        };
        delivery.StatusChanged += status =>
        {
            states.Add(status.State);
            elsewhere += window.IsCurrent ? 0 : 1;
        };
        reader.Start();
        using (TestConnection connection = await server.AcceptAsync())
        {
            await connection.SendAsync(TestPackets.Motions(0, 300));
            connection.Close();
        }

        FrameDeliveryEnd end = await delivery.Completion.Soon();
        Assert.Equal(FrameDeliveryEndReason.ReaderStopped, end.Reason);
        Assert.Equal(Enumerable.Range(0, 300).Select(static index => (uint?)index), frames);
        Assert.Equal([ConnectionState.Connecting, ConnectionState.Connected, ConnectionState.Receiving, ConnectionState.Stopped], states);
        Assert.Equal((0, 1), (elsewhere, window.MostOutstanding));
        Assert.Equal((300, 0L, 0), (delivery.Delivered, delivery.Dropped, delivery.Pending));
        Assert.Empty(window.Exceptions);
    }

    [Fact]
    public async Task A_delivery_can_be_opened_while_the_reader_runs()
    {
        await using var scene = await Scene.StartAsync();
        await scene.SendAsync(0, 5);
        FrameDelivery late = scene.Window.Invoke(() => scene.Reader.OpenDelivery());
        List<uint?> frames = [];
        late.MotionReceived += frame => frames.Add(frame.FrameIndex);
        await scene.SendAsync(5, 5);
        await Limits.UntilAsync(() => late.Delivered == 5);
        scene.Window.Drain();
        Assert.Equal([5u, 6u, 7u, 8u, 9u], frames);
    }

    [Fact]
    public async Task A_handlers_exception_reaches_the_window_and_the_next_frame_follows()
    {
        await using var scene = await Scene.StartAsync();
        scene.Delivery.MotionReceived += static frame => throw new FormatException($"{frame.FrameIndex}");
        await scene.SendAsync(0, 3);
        await Limits.UntilAsync(() => scene.Window.Exceptions.Count == 3);
        Assert.Equal(["0", "1", "2"], scene.Window.Exceptions.Select(static exception => exception.Message));
        Assert.Equal(0, scene.Reader.GetStatistics().CallbackFailures);
    }

    [Fact]
    public async Task The_reader_reconnects_while_the_window_is_busy()
    {
        await using var scene = await Scene.StartAsync(reconnect: true);
        List<ConnectionState> states = [];
        scene.Delivery.StatusChanged += status =>
        {
            // A status can repeat with another message.
            if (states.Count == 0 || states[^1] != status.State)
                states.Add(status.State);
        };
        using (scene.BlockWindow())
        {
            await scene.SendAsync(0, 10);
            scene.Connection.Close();
            scene.Connection = await scene.Server.AcceptAsync();
            await scene.SendAsync(10, 10);
            Assert.Empty(scene.Seen);
        }

        await Limits.UntilAsync(() => scene.Delivery.Delivered == 20);
        scene.Window.Drain();
        Assert.Equal(Enumerable.Range(0, 20).Select(static index => (uint?)index), scene.Seen);
        ConnectionState[] expected = [ConnectionState.Waiting, ConnectionState.Connecting, ConnectionState.Connected, ConnectionState.Receiving];
        await Limits.UntilAsync(() => scene.Window.Invoke(() => states.Count >= 4 && expected.SequenceEqual(states.Skip(states.Count - 4))));

        // The message that blocked the window counts too.
        Assert.InRange(scene.Window.MostOutstanding, 1, 2);
    }

    [Fact]
    public async Task A_window_that_hangs_affects_no_other_window()
    {
        await using var scene = await Scene.StartAsync();
        using var otherWindow = new MessageLoop();
        List<uint?> others = [];
        FrameDelivery other = otherWindow.Invoke(() => scene.Reader.OpenDelivery(new FrameDeliveryOptions { Capacity = 512, Name = "other" }));
        FrameDelivery newest = otherWindow.Invoke(() => scene.Reader.OpenDelivery(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest }));
        FrameDelivery small = scene.Window.Invoke(() => scene.Reader.OpenDelivery(new FrameDeliveryOptions { Capacity = 8, Name = "small" }));
        other.MotionReceived += frame => others.Add(frame.FrameIndex);
        using (scene.BlockWindow())
        {
            await scene.SendAsync(0, 100);
            await Limits.UntilAsync(() => other.Delivered == 100 && newest.Pending == 0);
        }

        otherWindow.Drain();
        await Limits.UntilAsync(() => small.Pending == 0 && scene.Delivery.Pending == 0);
        Assert.Equal(100, others.Count);
        Assert.Equal((100, 0L), (newest.Delivered + newest.Replaced, newest.Dropped));
        Assert.Equal((8, 92), (small.Delivered, small.Dropped));
        Assert.Equal(100, scene.Delivery.Delivered);
        Assert.Equal(92, scene.Reader.GetStatistics().Dropped);
    }

    [Fact]
    public async Task A_nested_message_loop_in_a_handler_gets_no_frames()
    {
        await using var scene = await Scene.StartAsync();
        int depth = 0;
        int deepest = 0;
        scene.Delivery.MotionReceived += _ =>
        {
            deepest = Math.Max(deepest, ++depth);
            scene.Window.RunNested();
            depth--;
        };
        for (int i = 0; i < 20; i++)
            await scene.SendAsync(i * 10, 10);

        await Limits.UntilAsync(() => scene.Delivery.Delivered == 200);
        scene.Window.Drain();
        Assert.Equal((1, 200), (deepest, scene.Seen.Count));
    }

    [Fact]
    public async Task Await_of_the_end_continues_on_the_windows_thread()
    {
        await using var scene = await Scene.StartAsync();
        Task<bool> waiting = scene.Window.Invoke(async () =>
        {
            await scene.Delivery.Completion;
            return scene.Window.IsCurrent;
        });
        scene.Delivery.Dispose();
        Assert.True(await waiting.Soon());
    }

    [Fact]
    public async Task A_flood_is_delivered_in_order_and_counted_completely()
    {
        await using var scene = await Scene.StartAsync(new FrameDeliveryOptions { Capacity = 64 });
        FrameDelivery newest = scene.Window.Invoke(() => scene.Reader.OpenDelivery(new FrameDeliveryOptions { Mode = FrameDeliveryMode.Newest }));
        uint? last = null;
        int disorder = 0;
        newest.MotionReceived += frame =>
        {
            disorder += last >= frame.FrameIndex ? 1 : 0;
            last = frame.FrameIndex;
        };
        byte[] burst = TestPackets.Motions(0, 5_000);
        await scene.Connection.SendAsync(burst);
        await scene.Reader.WaitForFramesAsync(5_000);
        await Limits.UntilAsync(() => scene.Delivery.Pending == 0 && newest.Pending == 0);
        scene.Window.Drain();
        Assert.Equal(5_000, scene.Delivery.Delivered + scene.Delivery.Dropped);
        Assert.Equal(5_000, newest.Delivered + newest.Replaced);
        Assert.Equal(scene.Delivery.Delivered, scene.Seen.Count);
        Assert.Equal(scene.Seen.Order(), scene.Seen);
        Assert.Equal((0, 4_999u), (disorder, last));
        Assert.InRange(scene.Window.MostOutstanding, 1, 2);
    }
}
