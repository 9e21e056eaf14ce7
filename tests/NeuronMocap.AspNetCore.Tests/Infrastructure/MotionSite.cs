using System.Net.WebSockets;
using Microsoft.AspNetCore.Builder;
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

    public static async Task<MotionSite> StartAsync(WebSocketBroadcasterOptions? options = null, Action<WebApplication>? map = null)
    {
        var server = new TestServer();
        var reader = new NeuronReader(server.Options());
        var broadcaster = new WebSocketBroadcaster(reader, options);
        reader.Start();
        TestConnection motion = await server.AcceptAsync();
        WebServer web = await WebServer.StartAsync(map: application =>
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
