using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Hosting;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.Connections;

// A broadcaster behind an address of Kestrel: the same as behind its own port.
public sealed class KestrelBroadcastTests
{
    [Fact]
    public async Task A_relay_passes_every_byte_on()
    {
        using var server = new TestServer();
        await using var source = new NeuronReader(server.Options());
        await using var relay = new Broadcaster(new BroadcasterOptions { Reader = source, Port = null, QueueCapacity = 1024 });
        relay.Start();
        source.Start();
        using TestConnection motion = await server.AcceptAsync();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseNeuronBroadcast(relay));
        using Socket client = await ConnectAsync(web);
        await Limits.UntilAsync(() => relay.GetStatistics().Clients == 1);

        byte[] packets = TestPackets.Join(TestPackets.Motions(1, 100), TestPackets.Calculation(100), TestPackets.Studio(100));
        await motion.SendAsync(packets);
        byte[] received = new byte[packets.Length];
        for (int count = 0; count < received.Length;)
        {
            int read = await client.ReceiveAsync(received.AsMemory(count), TestContext.Current.CancellationToken).Soon();
            Assert.NotEqual(0, read);
            count += read;
        }

        Assert.Equal(packets, received);

        // The bytes of a packet are counted before the packet.
        await Limits.UntilAsync(() => relay.GetClients() is [var each] && each.FramesSent + each.CalculationFramesSent == 102);
        Assert.Equal(packets.Length, relay.GetStatistics().BytesSent);
        BroadcasterClient described = Assert.Single(relay.GetClients());
        Assert.Equal((client.LocalEndPoint, 102, 0), (described.RemoteEndPoint, described.FramesSent + described.CalculationFramesSent, described.PacketsDropped));

        // The end of the source is the end of the stream, without a reset.
        await source.DisposeAsync();
        Assert.Equal(0, await client.ReceiveAsync(received, TestContext.Current.CancellationToken).Soon());
    }

    [Fact]
    public async Task Clients_can_ask_on_their_connection_and_on_the_command_channel()
    {
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, WaitForClient = true });
        broadcaster.Start();
        await using var commands = new CommandServer(broadcaster, new CommandServerOptions { MaxClients = 1 });
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseNeuronBroadcast(broadcaster));
        await using WebServer channel = await WebServer.StartAsync(listen => listen.UseNeuronCommands(commands));
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = web.Port, CommandPort = channel.Port });
        reader.Start();
        await reader.WaitForFramesAsync(2);
        Assert.Equal(1, await reader.DataCommands.GetAvatarCountAsync(cancellationToken: TestContext.Current.CancellationToken).Soon());
        await Limits.UntilAsync(() => reader.TryGetBody(0, out _));

        // One at a time: this one is told to go, and the reader is still served.
        using Socket second = await ConnectAsync(channel);
        await reader.DisposeAsync();
        await Limits.UntilAsync(() => commands.ClientCount <= 1);
        await commands.DisposeAsync();
        Assert.Equal(0, await second.ReceiveAsync(new byte[1], TestContext.Current.CancellationToken).Soon());
    }

    [Fact]
    public async Task A_client_that_never_reads_loses_its_own_packets_and_is_dropped()
    {
        using var server = new TestServer();
        await using var source = new NeuronReader(server.Options());
        await using var relay = new Broadcaster(new BroadcasterOptions { Reader = source, Port = null, QueueCapacity = 64, ClientTimeout = TimeSpan.FromSeconds(4) });
        relay.Start();
        source.Start();
        using TestConnection motion = await server.AcceptAsync();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseNeuronBroadcast(relay));
        using Socket sleeper = await ConnectAsync(web, receiveBuffer: 4096);
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = web.Port });
        reader.Start();
        await Limits.UntilAsync(() => relay.GetStatistics().Clients == 2);
        const int Burst = 30;
        int sent = 0;
        while (relay.GetStatistics().Clients == 2)
        {
            await motion.SendAsync(TestPackets.Motions(sent + 1, Burst));
            sent += Burst;
            await reader.WaitForFramesAsync(sent);
        }

        Assert.True(relay.GetStatistics().PacketsDropped > 0);
        Assert.Equal((sent, 0), (reader.GetStatistics().MotionFrames, reader.GetStatistics().Lost));
    }

    [Fact]
    public async Task A_full_or_stopped_broadcaster_refuses_with_a_reason_in_the_log()
    {
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, MaxClients = 1 });
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseNeuronBroadcast(broadcaster));
        using Socket early = await ConnectAsync(web);
        Assert.Equal(0, await early.ReceiveAsync(new byte[1], TestContext.Current.CancellationToken).Soon());
        Assert.Contains(web.Log, static line => line.EndsWith("The broadcaster has not been started.", StringComparison.Ordinal));

        broadcaster.Start();
        using Socket first = await ConnectAsync(web);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        using Socket second = await ConnectAsync(web);
        Assert.Equal(0, await second.ReceiveAsync(new byte[1], TestContext.Current.CancellationToken).Soon());
        Assert.Contains(web.Log, static line => line.Contains("no room for another client", StringComparison.Ordinal));
        Assert.Equal((1, 1), (broadcaster.GetStatistics().Accepted, broadcaster.GetStatistics().Refused));

        await broadcaster.DisposeAsync();
        using Socket late = await ConnectAsync(web);
        Assert.Equal(0, await late.ReceiveAsync(new byte[1], TestContext.Current.CancellationToken).Soon());
        Assert.Contains(web.Log, static line => line.EndsWith("The broadcaster has been stopped.", StringComparison.Ordinal));
    }

    [Fact]
    public async Task The_end_of_the_application_ends_the_clients()
    {
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null });
        broadcaster.Start();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseNeuronBroadcast(broadcaster));
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = web.Port, Reconnect = { Enabled = false } });
        reader.Start();
        await reader.WaitForFramesAsync(1);
        await web.StopAsync();
        await reader.Completion.Soon();
        Assert.Equal((ConnectionReason.ClosedByPeer, 0), (reader.Status.Reason, broadcaster.GetStatistics().Clients));
    }

    [Fact]
    public async Task A_client_that_closes_its_own_side_still_receives()
    {
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null });
        broadcaster.Start();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseNeuronBroadcast(broadcaster));
        using Socket client = await ConnectAsync(web);
        client.Shutdown(SocketShutdown.Send);
        byte[] buffer = new byte[64 * 1024];
        for (int count = 0; count < 20_000;)
        {
            int read = await client.ReceiveAsync(buffer, TestContext.Current.CancellationToken).Soon();
            Assert.NotEqual(0, read);
            count += read;
        }
    }

    [Fact]
    public async Task Clients_that_come_and_go_and_send_garbage_disturb_nobody()
    {
        // A reader that does not run for seconds loses nothing.
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, QueueCapacity = 4096 });
        broadcaster.Start();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseNeuronBroadcast(broadcaster));
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = web.Port });
        reader.Start();
        byte[] garbage = new byte[100_000];
        new Random(1).NextBytes(garbage);
        for (int i = 0; i < 20; i++)
        {
            using Socket client = await ConnectAsync(web);
            client.Send(garbage, 0, 1000 * i, SocketFlags.None, out _);
            if (i % 2 == 0)
                client.LingerState = new LingerOption(enable: true, seconds: 0);
        }

        await Limits.UntilAsync(() => broadcaster.GetStatistics() is { Clients: 1, Accepted: 21 });
        long received = reader.GetStatistics().MotionFrames;
        await reader.WaitForFramesAsync(received + 10);
        Assert.Equal((0, 0), (reader.GetStatistics().Lost, reader.GetStatistics().BytesSkipped));
        Assert.False(broadcaster.Completion.IsCompleted);
    }

    private static async Task<Socket> ConnectAsync(WebServer web, int? receiveBuffer = null)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        if (receiveBuffer is { } size)
            socket.ReceiveBufferSize = size;

        await socket.ConnectAsync(new IPEndPoint(IPAddress.Loopback, web.Port), TestContext.Current.CancellationToken).AsTask().Soon();
        return socket;
    }
}
