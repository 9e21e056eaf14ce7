using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.Broadcasts;

namespace NeuronMocap.Server.Tests;

public sealed class BroadcasterPacedTests
{
    // Fast enough for short tests. No test depends on whether the machine keeps up.
    private const double Rate = 2000;

    [Theory]
    [InlineData(null)]
    [InlineData(7)]
    [InlineData(1480)]
    [InlineData(65_536)]
    public async Task A_waited_for_client_gets_every_frame_and_then_the_end(int? fragment)
    {
        BroadcasterOptions options = Options();
        options.WaitForClient = true;
        options.MaxFrames = 200;
        options.Fragment = fragment;
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        List<byte[]> packets = await client.ReadToEndAsync();
        client.Dispose();
        await broadcaster.Completion.Soon();

        Expect.Frames(packets, options, 200);
        Assert.Equal(200, broadcaster.GetStatistics().FramesSent);
        Assert.Equal(200 * 1480, broadcaster.GetStatistics().BytesSent);
    }

    [Fact]
    public async Task Several_avatars_with_calculation_packets_share_the_tick()
    {
        BroadcasterOptions options = Options(avatars: 4);
        options.WaitForClient = true;
        options.MaxFrames = 50;
        options.Calculation = TestSource.WriteCalculation;
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);

        Expect.Frames(await client.ReadToEndAsync(), options, 50);
    }

    [Fact]
    public async Task A_late_client_starts_at_a_whole_packet_and_misses_none_after_it()
    {
        BroadcasterOptions options = Options();
        await using Broadcaster broadcaster = Started(options);
        using TestClient early = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        for (int i = 0; i < 20; i++)
            Assert.NotNull(await early.ReadAsync());

        using TestClient late = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        var packets = new List<byte[]>();
        while (packets.Count < 100)
            packets.Add((await late.ReadAsync())!);

        uint first = Expect.FrameIndex(packets[0]);
        Assert.True(first > 0);
        Expect.Frames(packets, options, packets.Count, first);
    }

    [Fact]
    public async Task A_client_that_does_not_read_loses_whole_packets_and_delays_nobody()
    {
        const int Avatars = 30;
        BroadcasterOptions options = Options(Avatars);
        options.FrameRate = 100;
        options.QueueCapacity = 200;
        var time = new ManualTime();
        await using var broadcaster = new Broadcaster(options, time);
        broadcaster.Start();
        using TestClient idle = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient reader = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 2);

        // The time for the next frame comes when the reading client has this one, however busy the machine is.
        var packets = new List<byte[]>();
        while (GetDropped(broadcaster, idle) < Avatars * 20)
        {
            await time.PassAsync();
            for (int avatar = 0; avatar < Avatars; avatar++)
                packets.Add((await reader.ReadAsync())!);
        }

        Assert.Equal(0, GetDropped(broadcaster, reader));
        Assert.True(broadcaster.GetStatistics().PacketsDropped >= Avatars * 20);

        // When the idle client finally reads, it finds whole frames: old frames, a gap, new frames.
        uint previous = 0;
        bool foundGap = false;
        while (!foundGap)
        {
            for (int avatar = 0; avatar < Avatars; avatar++)
            {
                byte[] packet = (await idle.ReadAsync())!;
                uint frame = Expect.FrameIndex(packet);
                Expect.Motion(packet, options, avatar, frame);
                foundGap |= avatar == 0 && previous != 0 && frame > previous + 1;
                previous = frame;
            }
        }

        // The reading client got every frame since it connected.
        int frames = packets.Count / Avatars;
        Assert.True(frames > 200);
        Expect.Frames(packets, options, frames, Expect.FrameIndex(packets[0]));
    }

    [Fact]
    public async Task Queued_packets_are_flushed_at_the_end()
    {
        BroadcasterOptions options = Options(avatars: 2);
        options.Port = FreePort.Next();
        options.WaitForClient = true;
        options.MaxFrames = 1500;
        options.QueueCapacity = 1500;
        options.CloseTimeout = TimeSpan.FromMinutes(10);
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);

        // It reads nothing before the last frame is created. After that, the server no longer listens.
        await Limits.UntilAsync(() => !CanConnect(broadcaster));

        Expect.Frames(await client.ReadToEndAsync(), options, 1500);
        Assert.False(broadcaster.Completion.IsCompleted);
        client.Dispose();
        await broadcaster.Completion.Soon();
        Assert.Equal(0, broadcaster.GetStatistics().PacketsDropped);
    }

    [Fact]
    public async Task A_client_that_never_reads_delays_the_end_up_to_a_limit()
    {
        BroadcasterOptions options = Options(avatars: 16);
        options.WaitForClient = true;
        options.MaxFrames = 600;
        options.CloseTimeout = TimeSpan.FromMilliseconds(50);
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        await broadcaster.Completion.Soon();

        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 0);
    }

    [Fact]
    public async Task A_take_without_clients_ends_on_time()
    {
        BroadcasterOptions options = Options();
        options.MaxFrames = 20;
        await using Broadcaster broadcaster = Started(options);
        await broadcaster.Completion.Soon();
        Assert.Equal(default, broadcaster.GetStatistics());
    }

    [Fact]
    public void The_rate_defaults_to_the_sources()
    {
        BroadcasterOptions options = Options();
        Assert.Equal(Rate, new Broadcaster(options).FrameRate);
        options.FrameRate = null;
        Assert.Equal(60, new Broadcaster(options).FrameRate);
    }

    private static BroadcasterOptions Options(int avatars = 1)
    {
        BroadcasterOptions options = Expect.Options(avatars);
        options.FrameRate = Rate;
        options.QueueCapacity = 10_000;
        return options;
    }

    private static long GetDropped(Broadcaster broadcaster, TestClient client) =>
        broadcaster.GetClients()
            .Where(entry => Equals(entry.RemoteEndPoint, client.Socket.LocalEndPoint))
            .Sum(entry => entry.PacketsDropped);

    private static bool CanConnect(Broadcaster broadcaster)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        try
        {
            socket.Connect(broadcaster.LocalEndPoint!);
            return true;
        }
        catch (SocketException)
        {
            return false;
        }
    }
}
