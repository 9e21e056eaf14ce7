using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Connections.Features;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.Connections;

// What the sockets of Kestrel get.
public sealed class ConnectionSocketTests
{
    private Socket? _socket;

    [Fact]
    public async Task A_client_of_a_broadcaster_that_vanishes_is_noticed()
    {
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null });
        broadcaster.Start();
        await using WebServer web = await WebServer.StartAsync(listen => Remember(listen).UseNeuronBroadcast(broadcaster));
        using var client = new TcpClient();
        await client.ConnectAsync(IPAddress.Loopback, web.Port, TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        AssertHasKeepAlive();
    }

    [Fact]
    public async Task A_WebSocket_client_that_vanishes_is_noticed()
    {
        await using MotionSite site = await MotionSite.StartAsync(listen: listen => Remember(listen));
        using Socket client = await site.ConnectRawAsync();
        AssertHasKeepAlive();
    }

    [Fact]
    public async Task A_client_of_a_broadcaster_that_pauses_finds_few_old_packets()
    {
        using var server = new TestServer();
        await using var source = new NeuronReader(server.Options());
        await using var relay = new Broadcaster(new BroadcasterOptions { Reader = source, Port = null, QueueCapacity = 64, ClientTimeout = TimeSpan.FromMinutes(10) });
        relay.Start();
        source.Start();
        using TestConnection motion = await server.AcceptAsync();
        await using WebServer web = await WebServer.StartAsync(listen => listen.UseNeuronBroadcast(relay));
        using var client = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { ReceiveBufferSize = 4096 };
        await client.ConnectAsync(IPAddress.Loopback, web.Port, TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => relay.GetStatistics().Clients == 1);

        // What the client does not read is not counted as sent, so the first packet goes alone.
        await motion.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => relay.GetStatistics().BytesSent > 0);
        const int Burst = 30;
        for (int sent = 1; relay.GetStatistics().PacketsDropped == 0;)
        {
            await motion.SendAsync(TestPackets.Motions(sent + 1, Burst));
            sent += Burst;
            await source.WaitForFramesAsync(sent);
        }

        Assert.InRange(relay.GetStatistics().BytesSent, 1, 400_000);
    }

    private ListenOptions Remember(ListenOptions listen)
    {
        listen.Use(next => connection =>
        {
            _socket = connection.Features.Get<IConnectionSocketFeature>()!.Socket;
            return next(connection);
        });
        return listen;
    }

    private void AssertHasKeepAlive() => Assert.NotEqual(0, (int)_socket!.GetSocketOption(SocketOptionLevel.Socket, SocketOptionName.KeepAlive)!);
}
