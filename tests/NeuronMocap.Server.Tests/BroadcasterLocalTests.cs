using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

// Readers in the same process, without a port.
public sealed class BroadcasterLocalTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(40)]
    public async Task A_reader_gets_the_bytes_of_a_client(int avatars)
    {
        BroadcasterOptions options = Expect.Options(avatars, frames: 100);
        (options.Port, options.Calculation) = (null, TestSource.WriteCalculation);
        using Broadcaster broadcaster = Broadcasts.Started(options);
        await using var reader = new NeuronReader(Local(broadcaster));
        var packets = new List<byte[]>();
        reader.MotionReceived += frame => packets.Add(frame.Packet.ToArray());
        reader.CalculationReceived += frame => packets.Add(frame.Packet.ToArray());
        var log = new StatusLog(reader);
        reader.Start();
        ConnectionStatus end = await log.WaitAsync(ConnectionState.Waiting);
        Assert.Equal((ConnectionReason.ClosedByPeer, "Receiving from the broadcaster has ended: there are no more bytes."), (end.Reason, end.Message));
        await broadcaster.Completion.Soon();
        Expect.Frames(packets, options, count: 100);
        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        Assert.Equal((100 * avatars, 100 * avatars, 0, 0), (statistics.FramesSent, statistics.CalculationFramesSent, statistics.PacketsDropped, statistics.Clients));
        Assert.Equal(reader.GetStatistics().BytesReceived, statistics.BytesSent);
    }

    [Fact]
    public async Task The_stream_has_a_thread_of_its_own_and_no_socket()
    {
        using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, WaitForClient = true });
        broadcaster.Start();
        Assert.Null(broadcaster.LocalEndPoint);
        await using var reader = new NeuronReader(Local(broadcaster, "the simulator"));
        var log = new StatusLog(reader);
        reader.Start();
        ConnectionStatus status = await log.WaitAsync(ConnectionState.Receiving);
        Assert.StartsWith("Receiving from the simulator: binary format", status.Message, StringComparison.Ordinal);
        Assert.Equal((ReceiveThread.Dedicated, null, null), (status.ReceiveThread, status.LocalEndPoint, status.RemoteEndPoint));
        BroadcasterClient client = Assert.Single(broadcaster.GetClients());
        Assert.Equal((null, false, false), (client.RemoteEndPoint, client.IsUdp, client.IsCalculation));

        await reader.DisposeAsync();
        Assert.Empty(broadcaster.GetClients());
        Assert.False(broadcaster.Completion.IsCompleted);
    }

    // The stream has only blocking reads, which would occupy as many threads of the pool as there are readers.
    [Theory]
    [InlineData(ReceiveThread.Auto)]
    [InlineData(ReceiveThread.Dedicated)]
    [InlineData(ReceiveThread.Pool)]
    public async Task No_reader_blocks_a_thread_of_the_pool(ReceiveThread thread)
    {
        using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null });
        NeuronReaderOptions options = Local(broadcaster);
        options.ReceiveThread = thread;
        await using var reader = new NeuronReader(options);
        int ofPool = 0;
        reader.MotionReceived += _ => ofPool += Thread.CurrentThread.IsThreadPoolThread ? 1 : 0;
        var log = new StatusLog(reader);
        reader.Start();
        Assert.Equal(ReceiveThread.Dedicated, (await log.WaitAsync(ConnectionState.Receiving)).ReceiveThread);
        await reader.WaitForFramesAsync(3);
        await reader.DisposeAsync();
        Assert.Equal(0, ofPool);
    }

    [Fact]
    public async Task A_reader_that_leaves_early_does_not_end_an_unpaced_broadcast()
    {
        BroadcasterOptions options = Expect.Options(frames: 500);
        options.Port = null;
        using Broadcaster broadcaster = Broadcasts.Started(options);
        ByteSource source = broadcaster.CreateLocalSource();
        using (Stream early = await source.OpenAsync(TestContext.Current.CancellationToken))
            Assert.NotEqual(0, early.Read(new byte[100], 0, 100));

        Assert.Empty(broadcaster.GetClients());
        Assert.False(broadcaster.Completion.IsCompleted);
        using (Stream late = await source.OpenAsync(TestContext.Current.CancellationToken))
            late.CopyTo(Stream.Null);

        // The first reader took one frame.
        await broadcaster.Completion.Soon();
        Assert.Equal(501, broadcaster.GetStatistics().FramesSent);
    }

    [Fact]
    public async Task A_reader_that_leaves_early_does_not_keep_an_unpaced_broadcast_over_udp_from_its_end()
    {
        using Socket end = Broadcasts.Receiver();
        BroadcasterOptions options = Expect.Options(frames: 5);
        (options.Port, options.UdpDestinations, options.WaitForClient) = (null, [(IPEndPoint)end.LocalEndPoint!], true);
        using Broadcaster broadcaster = Broadcasts.Started(options);
        (await broadcaster.CreateLocalSource().OpenAsync(TestContext.Current.CancellationToken)).Dispose();
        await broadcaster.Completion.Soon();
        Assert.Equal(5, broadcaster.GetStatistics().FramesSent);
    }

    [Fact]
    public async Task A_reader_waits_for_the_start_and_sees_the_end()
    {
        var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null });
        await using var reader = new NeuronReader(Local(broadcaster));
        var log = new StatusLog(reader);
        reader.Start();
        ConnectionStatus early = await log.WaitAsync(ConnectionState.Waiting);
        Assert.Equal((ConnectionReason.Refused, "Opening the broadcaster failed: The broadcaster has not been started."), (early.Reason, early.Message));
        broadcaster.Start();
        await log.WaitAsync(ConnectionState.Receiving);
        broadcaster.Dispose();
        await log.WaitAsync(static status => status.Reason == ConnectionReason.ClosedByPeer);
        await log.WaitAsync(static status => status.Message.EndsWith("The broadcaster has been stopped.", StringComparison.Ordinal));
        await Limits.UntilAsync(() => broadcaster.GetClients().Count == 0);
    }

    [Fact]
    public async Task A_reader_that_is_stuck_loses_its_own_frames_only()
    {
        var options = new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, FrameRate = 1000, QueueCapacity = 4 };
        using Broadcaster broadcaster = Broadcasts.Started(options);
        using var leave = new SemaphoreSlim(0);
        await using var stuck = new NeuronReader(Local(broadcaster));
        await using var free = new NeuronReader(Local(broadcaster));
        stuck.MotionReceived += _ => leave.Wait(Limits.Unexpected);
        stuck.Start();
        free.Start();
        await free.WaitForFramesAsync(100);
        await Limits.UntilAsync(() => broadcaster.GetClients().Sum(static client => client.PacketsDropped) > 0);
        leave.Release(int.MaxValue / 2);
    }

    [Fact]
    public async Task An_exception_of_a_source_ends_the_broadcast()
    {
        var options = new BroadcasterOptions { Sources = [new ThrowingSource(nameof(MotionSource.WriteValues), new InvalidOperationException("Broken.")) { IsBroken = true }], Port = null, FrameRate = BroadcasterOptions.MaxFrameRate };
        using Broadcaster broadcaster = Broadcasts.Started(options);
        await using var reader = new NeuronReader(Local(broadcaster));
        reader.Start();
        Assert.NotNull(await Record.ExceptionAsync(() => broadcaster.Completion.Soon()));
        await Limits.UntilAsync(() => broadcaster.GetClients().Count == 0);
    }

    [Fact]
    public async Task Stops_end_the_wait_of_a_reader()
    {
        for (int round = 0; round < 50; round++)
        {
            using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, FrameRate = 0.01 });
            await using var reader = new NeuronReader(Local(broadcaster));
            await reader.StartAsync().Soon();
            await Task.WhenAll(Task.Run(broadcaster.Dispose), Task.Run(reader.Dispose)).Soon();
            await reader.Completion.Soon();
            Assert.Empty(broadcaster.GetClients());
        }
    }

    [Fact]
    public void A_name_is_required()
    {
        using var broadcaster = new Broadcaster(Expect.Options());
        Assert.Throws<ArgumentException>("name", () => broadcaster.CreateLocalSource(" "));
    }

    private static NeuronReaderOptions Local(Broadcaster broadcaster, string name = "the broadcaster") => new()
    {
        Source = broadcaster.CreateLocalSource(name),
        StopTimeout = Limits.Unexpected,
        SilenceTimeout = Limits.Unexpected,
        Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) },
    };
}
