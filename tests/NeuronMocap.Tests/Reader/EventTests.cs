using NeuronMocap.Delivery;
using NeuronMocap.Telemetry;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

public sealed class EventTests
{
    private readonly List<ReaderEvent> _events = [];

    [Fact]
    public async Task States_losses_garbage_and_failures_are_told_once_each()
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
                (ReaderEventId.FramesDropped, 2), (ReaderEventId.BytesSkipped, 100), (ReaderEventId.HandlerFailed, 4), (ReaderEventId.Stopped, 0),
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
    public async Task A_reader_may_be_disposed_of_by_a_handler_of_events()
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
        }

        Assert.Equal(2, reader.GetStatistics().Reconnects);
    }

    // Several reports of one kind, where the timer came in between, count as one.
    private static IEnumerable<(ReaderEventId Id, long Count)> Sums(ReaderEvent[] events) =>
        events.GroupBy(reported => reported.Id).Select(group => (group.Key, group.Sum(reported => reported.Count))).OrderBy(Rank);

    private static int Rank((ReaderEventId Id, long Count) sum) => sum.Id == ReaderEventId.Stopped ? int.MaxValue : (int)sum.Id;

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
