using System.Net;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Tests.Reader;

// Alone, because it counts sockets and threads of the whole process, and because a port that is free for a moment must stay free.
[Collection(nameof(Alone))]
public sealed class ReconnectTests
{
    private const int Restarts = 1000;

    [Fact]
    public async Task A_thousand_restarts_lose_only_cut_frames()
    {
        int sockets = ProcessResources.Sockets;
        int threads = ProcessResources.LibraryThreads;
        var random = new Random(6);
        List<int> certain = [];
        List<int> received = [];
        List<ConnectionStatus> waits = [];
        int connected = 0;
        int newest = -1;
        int next = 0;
        using (var server = new ServerAtOneAddress())
        {
            await using var reader = new NeuronReader(server.Options());
            reader.MotionReceived += frame =>
            {
                received.Add((int)frame.FrameIndex!);
                Assert.Equal(TestPackets.Value((int)frame.FrameIndex!, 0, 353), frame.Values[353]);
                Volatile.Write(ref newest, received[^1]);
            };
            reader.StatusChanged += status =>
            {
                if (status.State == ConnectionState.Waiting)
                    waits.Add(status);
                else if (status.State == ConnectionState.Connected)
                    connected++;
            };
            reader.Start();
            for (int restart = 0; restart < Restarts; restart++)
            {
                using TestConnection connection = await server.AcceptAsync();
                int frames = random.Next(0, 4);
                await connection.SendAsync(TestPackets.Motions(next, frames));
                await connection.SendAsync(TestPackets.Motion(next + frames).AsMemory(0, random.Next(0, 1480)));

                // A reset discards data that the other side has not read. If the reader has read everything, nothing is lost.
                bool isReset = random.Next(2) == 0;
                bool isAwaited = random.Next(2) == 0;
                if (isAwaited)
                    await Limits.UntilAsync(() => frames == 0 || Volatile.Read(ref newest) == next + frames - 1);
                if (isAwaited || !isReset)
                    certain.AddRange(Enumerable.Range(next, frames));

                next += frames;
                server.Restart(isReset ? connection.Reset : connection.Close);
            }

            using TestConnection last = await server.AcceptAsync();
            await last.SendAsync(TestPackets.Motions(next, 3));
            certain.AddRange(Enumerable.Range(next, 3));
            await Limits.UntilAsync(() => Volatile.Read(ref newest) == next + 2);

            // Before the last connection ends.
            await reader.DisposeAsync();

            // Some of the resets came before the reader noticed that its connection was open.
            Assert.Equal((connected - 1, 0L), (reader.GetStatistics().Reconnects, reader.GetStatistics().Lost));
            Assert.InRange(connected, Restarts / 2, Restarts + 1);
            Assert.Equal(0, reader.GetStatistics().CallbackFailures);
        }

        Assert.Equal(received.Distinct().Order(), received);
        Assert.Empty(certain.Except(received));
        Assert.Equal(Restarts, waits.Count(wait => wait.Reason is ConnectionReason.ClosedByPeer or ConnectionReason.Reset));
        Assert.All(waits, wait => Assert.Contains(wait.Reason, (ConnectionReason[])[ConnectionReason.ClosedByPeer, ConnectionReason.Reset, ConnectionReason.Refused]));
        await ProcessResources.AssertNoMoreAsync(sockets, threads);
    }

    [Fact]
    public async Task Thousands_of_connections_leave_no_socket_thread_or_memory_behind()
    {
        const int Connections = 2000;
        const int Warm = 200;
        byte[] frame = TestPackets.Motion(1);
        int sockets = ProcessResources.Sockets;
        int threads = ProcessResources.LibraryThreads;
        long heap = 0;
        using (var server = new TestServer())
        {
            NeuronReaderOptions options = server.Options(reconnect: true);
            options.Reconnect.InitialDelay = options.Reconnect.MaxDelay = TimeSpan.FromTicks(1);
            await using var reader = new NeuronReader(options);
            reader.Start();
            for (int i = 0; i < Connections; i++)
            {
                using TestConnection connection = await server.AcceptAsync();
                if (i == Warm)
                    heap = ProcessResources.LiveHeap();

                // Every other connection is cut as early as possible, sometimes before the reader notices that it was open.
                if (i % 2 == 0)
                    await Limits.UntilAsync(() => IsConnectedTo(reader, connection));
                if (i % 8 == 0)
                    await connection.SendAsync(frame);
                if (i % 16 == 0)
                    connection.Close();
                else
                    connection.Reset();
            }

            using TestConnection last = await server.AcceptAsync();
            await last.SendAsync(frame);
            await Limits.UntilAsync(() => reader.Status.State == ConnectionState.Receiving && IsConnectedTo(reader, last));
            Assert.InRange(reader.GetStatistics().Reconnects, Connections / 2, Connections);
            heap = ProcessResources.LiveHeap() - heap;
        }

        Assert.InRange(heap, long.MinValue, 660_000);
        await ProcessResources.AssertNoMoreAsync(sockets, threads);
    }

    [Fact]
    public async Task A_restarted_broadcast_is_found_again_each_time()
    {
        BroadcasterOptions options = Expect.Options();
        options.FrameRate = 1000;
        options.QueueCapacity = 10_000;
        options.BindAddress = ServerAtOneAddress.Address;
        var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        options.Port = broadcaster.LocalEndPoint!.Port;
        await using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Host = options.BindAddress.ToString(),
            Port = options.Port.Value,
            Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) },
        });
        reader.Start();
        for (int restart = 0; restart < 20; restart++)
        {
            await ReceiveAsync(restart);
            await broadcaster.DisposeAsync();
            broadcaster = new Broadcaster(options);
            broadcaster.Start();
        }

        await ReceiveAsync(20);
        await broadcaster.DisposeAsync();
        Assert.Equal((20L, 0L), (reader.GetStatistics().Reconnects, reader.GetStatistics().Lost));

        // On the new connection. Frames of the previous one may still be in transit.
        async Task ReceiveAsync(int reconnects)
        {
            await reader.UntilAsync(statistics => statistics.Reconnects == reconnects);
            await reader.WaitForFramesAsync(reader.GetStatistics().MotionFrames + 3);
        }
    }

    private static bool IsConnectedTo(NeuronReader reader, TestConnection connection) =>
        reader.Status is { IsConnected: true } status && Equals(status.LocalEndPoint, connection.Socket.RemoteEndPoint);

    // A server that stops listening, cuts its connection and listens again on the same port. It uses its own address, if the system has such
    // addresses, so that no other program takes the port in the meantime.
    private sealed class ServerAtOneAddress : IDisposable
    {
        private TestServer _server = new(Address);

        public static IPAddress Address { get; } = Loopback.HasManyAddresses ? IPAddress.Parse("127.0.77.2") : IPAddress.Loopback;

        public NeuronReaderOptions Options() => new()
        {
            Host = Address.ToString(),
            Port = _server.Port,
            Reconnect = { InitialDelay = TimeSpan.FromTicks(1), MaxDelay = TimeSpan.FromTicks(1) },
        };

        public Task<TestConnection> AcceptAsync() => _server.AcceptAsync();

        // Closes the listener first, so that no connection can come in between.
        public void Restart(Action cut)
        {
            int port = _server.Port;
            _server.Dispose();
            cut();
            _server = new TestServer(Address, port);
        }

        public void Dispose() => _server.Dispose();
    }
}
