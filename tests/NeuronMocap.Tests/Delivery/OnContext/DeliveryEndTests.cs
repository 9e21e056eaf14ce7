namespace NeuronMocap.Tests.Delivery;

/// <summary>Exceptions of handlers, ends, and contexts that are gone.</summary>
public sealed class DeliveryEndTests
{
    [Fact]
    public void A_handlers_exception_leaves_the_post_and_the_next_frame_follows()
    {
        var bench = new DeliveryBench();
        List<uint?> others = [];
        bench.Delivery.MotionReceived += static frame =>
        {
            if (frame.FrameIndex == 1)
                throw new FormatException();
        };
        bench.Delivery.MotionReceived += frame => others.Add(frame.FrameIndex);
        bench.PushMany(0, 4);
        Assert.Throws<FormatException>(bench.Context.RunAll);
        bench.Clock.Advance(2);
        bench.Context.RunAll();
        Assert.Equal([0u, 1u, 2u, 3u], bench.Indices);
        Assert.Equal([0u, 2u, 3u], others);
        Assert.Null(bench.Delivery.End);
        bench.AssertSumsAddUp();
    }

    [Fact]
    public void A_handler_that_always_throws_gets_every_frame_once()
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = FrameDeliveryMode.EveryFrame });
        bench.Delivery.MotionReceived += static _ => throw new FormatException();
        bench.PushMany(0, 10);
        int thrown = 0;
        for (int i = 0; i < 100; i++)
        {
            if (bench.Context.Waiting > 0)
                thrown += Record.Exception(bench.Context.RunOne) is FormatException ? 1 : 0;
            bench.Clock.Advance(1);
        }

        Assert.Equal((10, 10), (thrown, bench.Seen.Count));
    }

    [Fact]
    public void An_exception_of_a_status_handler_does_not_stop_frames_or_the_end()
    {
        var bench = new DeliveryBench();
        bench.Delivery.StatusChanged += static _ => throw new FormatException();
        bench.Push(0);
        bench.Report(ConnectionState.Receiving);
        bench.Report(ConnectionState.Stopped);
        int thrown = 0;
        for (int i = 0; i < 100 && bench.Delivery.End is null; i++)
        {
            if (bench.Context.Waiting > 0)
                thrown += Record.Exception(bench.Context.RunOne) is FormatException ? 1 : 0;
            bench.Clock.Advance(1);
        }

        Assert.Equal((2, 1, FrameDeliveryEndReason.ReaderStopped), (thrown, bench.Seen.Count, bench.Delivery.End?.Reason));
    }

    [Theory]
    [InlineData(FrameDeliveryMode.EveryFrame)]
    [InlineData(FrameDeliveryMode.Newest)]
    public void After_a_dispose_in_a_handler_no_handler_is_called(FrameDeliveryMode mode)
    {
        var bench = new DeliveryBench(new FrameDeliveryOptions { Mode = mode });
        int later = 0;
        bench.Delivery.MotionReceived += _ => bench.Delivery.Dispose();
        bench.Delivery.MotionReceived += _ => later++;
        bench.Delivery.StatusChanged += _ => later++;
        bench.Push(0, avatar: 0);
        bench.Push(1, avatar: 1);
        bench.Context.RunAll();
        bench.Push(2);
        bench.Report(ConnectionState.Stopped);
        bench.Context.RunAll();
        Assert.Equal((1, 0), (bench.Seen.Count, later));
        Assert.Equal((FrameDeliveryEndReason.Disposed, 1), (bench.End.Reason, bench.Closed));
    }

    [Fact]
    public void After_a_dispose_with_a_post_outstanding_no_handler_is_called()
    {
        var bench = new DeliveryBench();
        bench.Delivery.StatusChanged += _ => bench.Seen.Add((0, 0));
        bench.Push(0);
        bench.Report(ConnectionState.Receiving);
        bench.Delivery.Dispose();
        bench.Delivery.Dispose();
        bench.Context.RunAll();
        bench.Push(1);
        Assert.Empty(bench.Seen);
        Assert.Equal((0, 1, true), (bench.Context.Waiting, bench.Closed, bench.Clock.IsDisposed));
    }

    [Fact]
    public void After_a_dispose_during_the_pause_of_a_burst_no_handler_is_called()
    {
        var bench = new DeliveryBench();
        bench.Delivery.MotionReceived += _ => bench.Clock.Advance(10);
        bench.PushMany(0, 5);
        bench.Context.RunAll();
        bench.Delivery.Dispose();
        bench.Clock.Advance(100);
        bench.Clock.Elapsed!();
        bench.Context.RunAll();
        Assert.Equal([0u], bench.Indices);
    }

    [Fact]
    public void Stopping_the_reader_ends_the_delivery_without_another_handler()
    {
        var bench = new DeliveryBench();
        bench.PushMany(0, 3);
        bench.Pipeline.Stop();
        bench.Context.RunAll();
        Assert.Empty(bench.Seen);
        Assert.Equal(FrameDeliveryEndReason.ReaderStopped, bench.Delivery.End?.Reason);
    }

    [Fact]
    public void A_context_that_throws_ends_the_delivery_and_not_the_receive_thread()
    {
        var bench = new DeliveryBench();
        using FrameQueue other = bench.Pipeline.OpenQueue(8, "other");
        bench.Push(0);
        bench.Context.RunAll();
        bench.Context.Posting = static () => throw new ObjectDisposedException("Form1");
        bench.PushMany(1, 3);
        FrameDeliveryEnd end = bench.End;
        Assert.Equal(FrameDeliveryEndReason.ContextGone, end.Reason);
        Assert.IsType<ObjectDisposedException>(end.Exception);
        Assert.Contains("ObjectDisposedException", end.Message, StringComparison.Ordinal);
        Assert.Equal((4, 4, 1), (bench.Statistics.MotionFrames, other.Count, bench.Closed));
        bench.Delivery.Dispose();
        Assert.Same(end, bench.Delivery.End);
    }

    [Fact]
    public void A_context_that_throws_during_a_run_ends_the_delivery_and_not_the_window()
    {
        var bench = new DeliveryBench();
        bench.Delivery.MotionReceived += _ =>
        {
            if (bench.Seen.Count > 1)
                return;

            // The status comes too late for this run, which therefore posts the next one.
            bench.Context.Posting = static () => throw new InvalidOperationException("The window is closed.");
            bench.Report(ConnectionState.Silent);
        };
        bench.Push(0);
        Assert.Null(Record.Exception(bench.Context.RunAll));
        bench.Push(1);
        Assert.Equal((FrameDeliveryEndReason.ContextGone, 1, 2), (bench.Delivery.End?.Reason, bench.Seen.Count, bench.Context.Posts));
    }

    [Fact]
    public void A_post_function_runs_the_handlers_where_it_likes_and_tells_when_it_is_gone()
    {
        var posted = new Queue<Action>();
        bool isGone = false;
        var bench = new DeliveryBench(new FrameDeliveryOptions
        {
            Post = action =>
            {
                posted.Enqueue(action);
                return !isGone;
            },
        });
        bench.PushMany(0, 2);
        Action first = Assert.Single(posted);
        posted.Dequeue()();
        bench.Push(2);
        Assert.Same(first, Assert.Single(posted));
        posted.Dequeue()();
        isGone = true;
        bench.Push(3);
        Assert.Equal((FrameDeliveryEndReason.ContextGone, 3), (bench.Delivery.End!.Reason, bench.Seen.Count));
        posted.Dequeue()();
        Assert.Equal(3, bench.Seen.Count);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_context_that_runs_posts_at_once_ends_the_delivery_before_a_handler_runs(bool isFunction)
    {
        var bench = new DeliveryBench(isFunction
            ? new FrameDeliveryOptions
            {
                Post = static action =>
                {
                    action();
                    return true;
                },
            }
            : new FrameDeliveryOptions { Context = new InlineContext() });
        bench.PushMany(0, 2);
        Assert.Empty(bench.Seen);
        Assert.Equal(FrameDeliveryEndReason.NotPosted, bench.Delivery.End?.Reason);
    }

    // The window runs a post, and gets the next, before the call that posted the first returns. That call then runs the post at once.
    [Fact]
    public void A_post_that_runs_at_once_is_noticed_while_another_post_is_made()
    {
        bool isFirst = true;
        DeliveryBench? bench = null;
        bench = new DeliveryBench(new FrameDeliveryOptions
        {
            Post = action =>
            {
                if (!isFirst)
                    return true;

                isFirst = false;
                var window = new Thread(() =>
                {
                    action();
                    bench!.Push(1);
                });
                window.Start();
                window.Join();
                action();
                return true;
            },
        });
        bench.Push(0);
        Assert.Equal([0u], bench.Indices);
        Assert.Equal(FrameDeliveryEndReason.NotPosted, bench.Delivery.End?.Reason);
    }

    [Fact]
    public void Opening_without_a_context_names_what_to_set()
    {
        using var reader = new NeuronReader("127.0.0.1");
        InvalidOperationException? exception = null;
        var thread = new Thread(() => exception = Record.Exception(() => reader.OpenDelivery()) as InvalidOperationException);
        thread.Start();
        thread.Join();
        Assert.Contains("set Context or Post", exception?.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Options_out_of_range_are_named()
    {
        using var reader = new NeuronReader("127.0.0.1");
        AssertFault("Context and Post", options => options.Post = static _ => true);
        AssertFault("Mode", static options => options.Mode = (FrameDeliveryMode)2);
        AssertFault("MaxRate", static options => (options.Mode, options.MaxRate) = (FrameDeliveryMode.Newest, -1));
        AssertFault("MaxRate", static options => (options.Mode, options.MaxRate) = (FrameDeliveryMode.Newest, double.NaN));
        AssertFault("MaxRate", static options => (options.Mode, options.MaxRate) = (FrameDeliveryMode.Newest, 0.001));
        AssertFault("MaxRate", static options => (options.Mode, options.MaxRate) = (FrameDeliveryMode.Newest, 1001));
        AssertFault("MaxRate and EveryNth", static options => (options.MaxRate, options.EveryNth) = (30, 2));
        AssertFault("EveryNth", static options => options.EveryNth = 0);
        AssertFault("EveryNth", static options => (options.Mode, options.EveryNth) = (FrameDeliveryMode.Newest, 2));
        AssertFault("WhenFull", static options => options.WhenFull = (WhenFull)9);
        AssertFault("WhenFull", static options => (options.Mode, options.WhenFull) = (FrameDeliveryMode.Newest, WhenFull.Wait));
        AssertFault("Capacity", static options => options.Capacity = 0);
        AssertFault("Name", static options => options.Name = " ");

        void AssertFault(string name, Action<FrameDeliveryOptions> change)
        {
            var options = new FrameDeliveryOptions { Context = new ManualContext() };
            change(options);
            Assert.StartsWith(name, Assert.Throws<ArgumentException>(() => reader.OpenDelivery(options)).Message, StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task A_delivery_opened_after_the_end_of_the_reader_has_ended()
    {
        var reader = new NeuronReader("127.0.0.1");
        reader.Dispose();
        await reader.Completion.Soon();
        var context = new ManualContext();
        FrameDelivery delivery = reader.OpenDelivery(new FrameDeliveryOptions { Context = context });
        Assert.Equal((FrameDeliveryEndReason.ReaderStopped, 0), (delivery.End?.Reason, context.Posts));
        delivery.Dispose();
    }

    private sealed class InlineContext : SynchronizationContext
    {
        public override void Post(SendOrPostCallback d, object? state) => d(state);
    }
}
