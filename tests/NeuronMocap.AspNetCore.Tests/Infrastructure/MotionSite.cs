using System.Net;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.Infrastructure;

/// <summary>A server of motion that the test writes, a reader, and a web application that sends on what it receives.</summary>
internal sealed class MotionSite : IAsyncDisposable
{
    private readonly TestServer _server;

    private MotionSite(TestServer server, NeuronReader reader, WebSocketBroadcaster broadcaster, TestConnection motion, WebServer web) =>
        (_server, Reader, Broadcaster, Motion, Web) = (server, reader, broadcaster, motion, web);

    public NeuronReader Reader { get; }

    public WebSocketBroadcaster Broadcaster { get; }

    /// <summary>Sends packets to the reader.</summary>
    public TestConnection Motion { get; }

    public WebServer Web { get; }

    public string Address => $"ws://127.0.0.1:{Web.Port}/motion";

    public static async Task<MotionSite> StartAsync(WebSocketBroadcasterOptions? options = null, Action<WebApplication>? map = null, Action<ListenOptions>? listen = null)
    {
        var server = new TestServer();
        var reader = new NeuronReader(server.Options());
        var broadcaster = new WebSocketBroadcaster(reader, options);
        reader.Start();
        TestConnection motion = await server.AcceptAsync();
        WebServer web = await WebServer.StartAsync(listen, application =>
        {
            application.MapNeuronWebSocket("/motion", broadcaster);
            map?.Invoke(application);
        });
        return new MotionSite(server, reader, broadcaster, motion, web);
    }

    /// <summary>Connects a client, and waits until the server counts it.</summary>
    public async Task<ClientWebSocket> ConnectAsync(string? subprotocol = null, string query = "", Action<ClientWebSocketOptions>? configure = null)
    {
        long before = Broadcaster.GetStatistics().Accepted;
        var client = new ClientWebSocket();
        if (subprotocol is not null)
            client.Options.AddSubProtocol(subprotocol);

        configure?.Invoke(client.Options);
        await client.ConnectAsync(new Uri(Address + query), TestContext.Current.CancellationToken).Soon();
        await Limits.UntilAsync(() => Broadcaster.GetStatistics().Accepted > before);
        return client;
    }

    /// <summary>Connects a client for JSON without a library, which reads nothing by itself. The system holds little for it.</summary>
    public async Task<Socket> ConnectRawAsync()
    {
        long before = Broadcaster.GetStatistics().Accepted;
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { ReceiveBufferSize = 4096 };
        await socket.ConnectAsync(new IPEndPoint(IPAddress.Loopback, Web.Port), TestContext.Current.CancellationToken).AsTask().Soon();
        await socket.SendAsync(
            Encoding.ASCII.GetBytes("GET /motion HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n"),
            TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => Broadcaster.GetStatistics().Accepted > before);
        return socket;
    }

    /// <summary>Sends frames until the only client for JSON takes no more, because it does not read, or is dropped for that.</summary>
    public async Task FillAsync()
    {
        const int Burst = 20;
        const int MostThatWait = 16;
        const int Enough = 5;
        int sent = 0;
        long taken = 0;
        for (int bursts = 0; bursts < Enough && Find() is not null;)
        {
            await Motion.SendAsync(TestPackets.Motions(sent + 1, Burst));
            sent += Burst;
            await Limits.UntilAsync(() => Find() is not { } now || now.FramesSent + now.FramesDropped >= sent - MostThatWait);
            long before = taken;
            taken = Find()?.FramesSent ?? before;

            // On a busy machine, the thread that sends to the client may only be late. Nothing else tells the two apart.
            bursts = taken > 0 && taken == before ? bursts + 1 : 0;
            if (bursts > 0)
                await Task.Delay(100, TestContext.Current.CancellationToken);
        }

        WebSocketClientStatistics? Find() => Broadcaster.GetClients()
            .Where(static client => client.Form == WebSocketForm.Json)
            .Select(static client => (WebSocketClientStatistics?)client)
            .SingleOrDefault();
    }

    /// <summary>Waits until the clients together have got, or lost, this number of frames.</summary>
    public Task UntilHandledAsync(long frames) => Limits.UntilAsync(() =>
    {
        WebSocketBroadcasterStatistics now = Broadcaster.GetStatistics();
        return now.FramesSent + now.FramesDropped + now.FramesSkipped + now.FramesMissed >= frames;
    });

    public async ValueTask DisposeAsync()
    {
        await Reader.DisposeAsync();
        await Broadcaster.DisposeAsync();
        await Web.DisposeAsync();
        Motion.Dispose();
        _server.Dispose();
    }
}
