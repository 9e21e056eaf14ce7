using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed class EventTests
{
    private readonly List<ReaderEvent> _events = [];

    [Fact]
    public async Task States_losses_garbage_and_failures_are_reported_once()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.Name = "stage";
        using var reader = new NeuronReader(options);
        reader.EventReported += Keep;
        reader.MotionReceived += _ => throw new InvalidOperationException("no disk");
        using FrameQueue queue = reader.OpenQueue(2, "draw");
        reader.Start();
        using (TestConnection connection = await server.AcceptAsync())
        {
            await connection.SendAsync(new byte[100]);
            await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1), TestPackets.Motion(2), TestPackets.Motion(5), TestPackets.Motion(6)));
        }

        await reader.Completion.Soon();
        await Limits.UntilAsync(() => Events().Length >= 8);
        ReaderEvent[] events = Events();
        Assert.Equal(
            [
                (ReaderEventId.Connecting, 0L), (ReaderEventId.Connected, 0), (ReaderEventId.Receiving, 0), (ReaderEventId.FramesLost, 2),
                (ReaderEventId.FramesDropped, 2), (ReaderEventId.BytesSkipped, 100), (ReaderEventId.CallbackFailed, 4), (ReaderEventId.Stopped, 0),
            ],
            Sums(events));
        Assert.All(events, reported => Assert.Equal("stage", reported.Reader));
        Assert.Equal("draw", events.First(reported => reported.Id == ReaderEventId.FramesDropped).Subject);
        Assert.Equal(ConnectionReason.ClosedByPeer, events[^1].Status!.Value.Reason);
    }

    [Fact]
    public async Task A_throwing_handler_of_events_is_counted_and_breaks_nothing()
    {
        using var server = new TestServer();
        using var reader = new NeuronReader(server.Options());
        int failures = 0;
        reader.CallbackFailed += _ => Interlocked.Increment(ref failures);
        reader.EventReported += _ => throw new InvalidOperationException("no disk");
        reader.EventReported += Keep;
        reader.Start();
        using (TestConnection connection = await server.AcceptAsync())
        {
            await connection.SendAsync(TestPackets.Motions(1, 10));
            await reader.WaitForFramesAsync(10);
        }

        await reader.Completion.Soon();
        Assert.Equal(10, reader.GetStatistics().MotionFrames);
        Assert.Contains(Events(), reported => reported.Id == ReaderEventId.Receiving);
        Assert.InRange(failures, 4, 100);
    }

    [Fact]
    public async Task An_event_handler_may_dispose_the_reader()
    {
        using var server = new TestServer();
        using var reader = new NeuronReader(server.Options());
        reader.EventReported += reported =>
        {
            if (reported.Id == ReaderEventId.Connected)
                reader.Dispose();
        };
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await reader.Completion.Soon();
        Assert.Equal(ConnectionReason.Requested, reader.Status.Reason);
    }

    [Fact]
    public async Task A_loss_handler_may_dispose_the_reader()
    {
        using var server = new TestServer();
        using var reader = new NeuronReader(server.Options());
        var order = new List<string>();
        reader.EventReported += reported =>
        {
            Keep(reported);
            if (reported.Id != ReaderEventId.FramesLost)
                return;

            reader.Dispose();
            lock (_events)
                order.AddRange(_events.Select(earlier => earlier.Id.ToString()));
        };
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1), TestPackets.Motion(2), TestPackets.Motion(5), TestPackets.Motion(6)));
        await reader.Completion.Soon();

        // The handler continued before the reader reported its end, because the report waits for the handler.
        Assert.DoesNotContain("Stopped", order);
        Assert.Contains("FramesLost", order);
        Assert.Equal(ReaderEventId.Stopped, Events()[^1].Id);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_stop_waits_for_a_loss_handler(bool asynchronous)
    {
        using var server = new TestServer();
        var reader = new NeuronReader(server.Options());
        var entered = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        bool busy = false;
        reader.MotionReceived += _ => throw new InvalidOperationException("no disk");
        reader.EventReported += reported =>
        {
            Keep(reported);
            if (reported.Id != ReaderEventId.BytesSkipped)
                return;

            Volatile.Write(ref busy, true);
            entered.TrySetResult();
            Thread.Sleep(300); // longer than a stop that does not wait
            Volatile.Write(ref busy, false);
        };
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(new byte[100], TestPackets.Motion(1)));

        // The report may begin between the bytes and the frame, which a stopped reader would not deliver.
        await reader.WaitForFramesAsync(1);
        await entered.Task.Soon();
        if (asynchronous)
            await reader.DisposeAsync();
        else
            reader.Dispose();

        Assert.False(Volatile.Read(ref busy));

        // The receive thread reports its state when it can, during the report or before.
        IEnumerable<ReaderEventId> events = Events().Select(reported => reported.Id).Where(id => id != ReaderEventId.Receiving);
        Assert.Equal(
            [ReaderEventId.Connecting, ReaderEventId.Connected, ReaderEventId.BytesSkipped, ReaderEventId.CallbackFailed, ReaderEventId.Stopped], events);
    }

    [Fact]
    public async Task Earlier_losses_are_reported_to_the_first_listener()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.SilenceTimeout = TimeSpan.FromSeconds(0.1);
        using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1), TestPackets.Motion(2), TestPackets.Motion(5), TestPackets.Motion(6)));
        await reader.WaitForFramesAsync(4);
        await log.WaitAsync(ConnectionState.Silent); // set by the timer that also looks for losses
        reader.EventReported += Keep;
        await Limits.UntilAsync(() => Events().Any(reported => reported.Id == ReaderEventId.FramesLost));
        Assert.Equal(2, Events().First(reported => reported.Id == ReaderEventId.FramesLost).Count);
    }

    [Fact]
    public async Task An_exception_with_a_throwing_message_does_not_block_the_end()
    {
        using var server = new TestServer();
        using var reader = new NeuronReader(server.Options());
        reader.EventReported += Keep;
        reader.MotionReceived += _ => throw new Unspeakable();
        reader.Start();
        using (TestConnection connection = await server.AcceptAsync())
            await connection.SendAsync(TestPackets.Motions(1, 3));

        await reader.Completion.Soon();
        Assert.Equal(ReaderEventId.Stopped, Events()[^1].Id);
    }

    [Fact]
    public void A_reader_without_a_name_is_called_after_its_server()
    {
        using var tcp = new NeuronReader("fe80::1", 7003);
        using var udp = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = 7012 });
        Assert.StartsWith("[fe80::1]:7003", tcp.Name, StringComparison.Ordinal);
        Assert.StartsWith("UDP port 7012", udp.Name, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => new NeuronReader(new NeuronReaderOptions { Name = " " }));
        Assert.Throws<ArgumentException>(() => tcp.OpenQueue(4, " "));
    }

    [Fact]
    public async Task Connections_after_the_first_are_counted()
    {
        using var server = new TestServer();
        using var reader = new NeuronReader(server.Options(reconnect: true));
        reader.Start();
        for (int i = 0; i < 3; i++)
        {
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motion(i));
            await reader.WaitForFramesAsync(i + 1);

            // The reader connects again as soon as this connection is closed.
            Assert.Equal(i, reader.GetStatistics().Reconnects);
        }
    }

    // Several reports of one kind, separated by the timer, count as one.
    private static IEnumerable<(ReaderEventId Id, long Count)> Sums(ReaderEvent[] events) =>
        events.GroupBy(reported => reported.Id).Select(group => (group.Key, group.Sum(reported => reported.Count))).OrderBy(Rank);

    private static int Rank((ReaderEventId Id, long Count) sum) => sum.Id == ReaderEventId.Stopped ? int.MaxValue : (int)sum.Id;

    private sealed class Unspeakable : Exception
    {
        public override string Message => throw new InvalidOperationException("No words.");
    }

    private void Keep(ReaderEvent reported)
    {
        lock (_events)
            _events.Add(reported);
    }

    private ReaderEvent[] Events()
    {
        lock (_events)
            return [.. _events];
    }
}
