using System.Diagnostics;
using System.Net.Sockets;
using System.Runtime.ExceptionServices;
using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.Broadcasts;

namespace NeuronMocap.Server.Tests;

// Clients that hang, floods of clients, and a system without memory, each beside a client that must not be affected.
public sealed class BroadcasterHostilityTests
{
    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(200)]
    public async Task A_client_that_stops_reading_is_dropped_and_frees_its_place(double rate)
    {
        BroadcasterOptions options = Expect.Options(avatars: 30);
        options.FrameRate = rate;
        options.MaxClients = 2;
        options.ClientTimeout = TimeSpan.FromSeconds(3);
        options.QueueCapacity = 20_000;
        await using Broadcaster broadcaster = Started(options);
        using TestClient idle = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient witness = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        Task<List<byte[]>> reading = ReadUntilAsync(witness, () => broadcaster.GetStatistics() is { Accepted: 2, Clients: 1 });
        List<byte[]> packets = await reading.Soon();

        using TestClient next = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        Assert.NotNull(await next.ReadAsync());
        Expect.Frames(packets[..(packets.Count / 30 * 30)], options, packets.Count / 30, Expect.FrameIndex(packets[0]));

        // Its queued data is discarded too. A graceful end would keep that data until the client reads it.
        SocketException end = await Assert.ThrowsAsync<SocketException>(() => idle.ReadToEndAsync());
        Assert.Equal(SocketError.ConnectionReset, end.SocketErrorCode);
    }

    // A frame of all avatars, 1.4 MB, is longer than what the client takes in time. A busy machine may keep the client itself from reading for so long, so
    // it may try again. A server that disconnects slow clients does so every time.
    [Fact]
    public async Task A_client_that_is_slow_but_steady_stays()
    {
        const int Attempts = 3;
        BroadcasterOptions options = Expect.Options(avatars: 256);
        options.Calculation = TestSource.WriteCalculation;
        options.ClientTimeout = TimeSpan.FromSeconds(3);
        await using Broadcaster broadcaster = Started(options);
        bool stays = false;
        for (int i = 0; i < Attempts && !stays; i++)
            stays = await TryTakeSlowlyAsync(broadcaster);

        Assert.True(stays, $"Each of {Attempts} clients was disconnected.");
    }

    [Fact]
    public async Task Connections_beyond_the_limit_do_not_affect_admitted_clients()
    {
        const int Flood = 300;
        BroadcasterOptions options = Expect.Options();
        options.FrameRate = 500;
        options.MaxClients = 8;
        options.QueueCapacity = 20_000;
        await using Broadcaster broadcaster = Started(options);
        using TestClient witness = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        byte[] first = (await witness.ReadAsync())!;

        // No client reads. Seven clients are accepted and stay; the others are rejected.
        List<TestClient> flood = [];
        for (int i = 0; i < Flood; i++)
            flood.Add(await TestClient.ConnectAsync(broadcaster.LocalEndPoint));

        List<byte[]> packets = [first, .. await ReadUntilAsync(witness, () => broadcaster.GetStatistics() is { Accepted: 8, Refused: Flood - 7 })];
        packets.AddRange(await ReadUntilAsync(witness, () => packets.Count > 100, packets));
        Expect.Frames(packets, options, packets.Count, Expect.FrameIndex(packets[0]));
        Assert.Equal(8, broadcaster.GetStatistics().Clients);
        flood.ForEach(client => client.Dispose());
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
    }

    [Fact]
    public async Task Out_of_memory_in_a_clients_thread_ends_only_that_client()
    {
        BroadcasterOptions options = Expect.Options();
        options.Sources = [new StumblingSource(badFrame: 50, new InsufficientMemoryException())];
        await using Broadcaster broadcaster = Started(options);
        using TestClient victim = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await victim.ReadToEndAsync();
        using TestClient other = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        for (int i = 0; i < 200; i++)
            Assert.Equal((uint)i, Expect.FrameIndex((await other.ReadAsync())!));

        Assert.False(broadcaster.Completion.IsCompleted);
    }

    [Fact]
    public async Task A_socket_exception_of_a_source_ends_the_broadcast()
    {
        BroadcasterOptions options = Expect.Options();
        options.Sources = [new StumblingSource(badFrame: 50, new ObjectDisposedException("take"))];
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await client.ReadToEndAsync();
        await Assert.ThrowsAsync<ObjectDisposedException>(() => broadcaster.Completion.Soon());
    }

    [Theory]
    [InlineData(typeof(InsufficientMemoryException))]
    [InlineData(typeof(InvalidOperationException))]
    public async Task A_client_without_a_thread_is_refused_and_the_next_is_served(Type failure)
    {
        int refused = 0;
        BroadcasterOptions options = Expect.Options();
        await using var broadcaster = new Broadcaster(options)
        {
            StartWorker = worker =>
            {
                if (refused++ == 0)
                    ExceptionDispatchInfo.Throw((Exception)Activator.CreateInstance(failure)!);

                worker.Start();
            },
        };
        broadcaster.Start();
        using TestClient first = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        Assert.Null(await first.ReadAsync());
        using TestClient second = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        Assert.Equal(0u, Expect.FrameIndex((await second.ReadAsync())!));
        Assert.Equal((1L, 1L), (broadcaster.GetStatistics().Accepted, broadcaster.GetStatistics().Refused));
    }

    [Fact]
    public async Task A_missing_frame_thread_ends_the_broadcast_with_a_reason()
    {
        BroadcasterOptions options = Expect.Options();
        options.FrameRate = 100;
        options.WaitForClient = true;
        await using var broadcaster = new Broadcaster(options)
        {
            StartWorker = worker =>
            {
                if (worker.Name == "NeuronMocap pacer")
                    ExceptionDispatchInfo.Throw(new InsufficientMemoryException());

                worker.Start();
            },
        };
        broadcaster.Start();
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        Assert.Null(await client.ReadAsync());
        await Assert.ThrowsAsync<InsufficientMemoryException>(() => broadcaster.Completion.Soon());
    }

    // Returns false if the broadcaster ends the connection.
    private static async Task<bool> TryTakeSlowlyAsync(Broadcaster broadcaster)
    {
        const int BytesPerSecond = 400_000;
        const int Enough = 2_800_000;
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        client.Socket.ReceiveBufferSize = 256 * 1024;
        byte[] buffer = new byte[64 * 1024];
        long start = Stopwatch.GetTimestamp();
        int taken = 0;
        while (taken < Enough)
        {
            int due = (int)(Stopwatch.GetElapsedTime(start).TotalSeconds * BytesPerSecond) - taken;
            if (due <= 0)
            {
                await Task.Delay(5, TestContext.Current.CancellationToken);
                continue;
            }

            int read;
            try
            {
                read = await client.Socket.ReceiveAsync(buffer.AsMemory(0, Math.Min(due, buffer.Length)), TestContext.Current.CancellationToken).Soon();
            }
            catch (SocketException)
            {
                return false;
            }

            if (read == 0)
                return false;

            taken += read;
        }

        return broadcaster.GetStatistics().Clients == 1;
    }

    private static async Task<List<byte[]>> ReadUntilAsync(TestClient client, Func<bool> condition, List<byte[]>? into = null)
    {
        List<byte[]> packets = [];
        while (!condition())
        {
            byte[] packet = (await client.ReadAsync())!;
            (into ?? packets).Add(packet);
        }

        return packets;
    }

    // Fails once, in one frame.
    private sealed class StumblingSource(long badFrame, Exception exception) : MotionSource
    {
        private int _failures;

        public override double FrameRate => 60;

        public override long? FrameCount => null;

        public override bool HasDisplacement => false;

        public override void GetPose(long frame, Span<BoneTransform> pose)
        {
            if (frame == badFrame && Interlocked.Exchange(ref _failures, 1) == 0)
                throw exception;

            pose.Fill(BoneTransform.Identity);
        }

        public override FootContacts GetFootContacts(long frame) => new(false, false);
    }
}
