using System.Net;
using Microsoft.AspNetCore.Builder;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.Listening;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A web server with one address, for WebSocket clients.</summary>
internal sealed class WebSocketOutlet : Outlet
{
    private readonly WebListener _listener;
    private readonly WebSocketBroadcaster _broadcaster;

    private WebSocketOutlet(WebListener listener, WebSocketBroadcaster broadcaster, bool isOpen)
    {
        (_listener, _broadcaster) = (listener, broadcaster);
        Name = $"{WebSocketDestination.Scheme}{listener.LocalEndPoint}";
        Announcement = $"Listening on {Name}{(isOpen ? ": anybody who reaches this port may connect; --token WORD limits it" : string.Empty)}";
    }

    public override string Name { get; }

    public override string Announcement { get; }

    public override string Noun => "frame";

    /// <summary>Starts to listen.</summary>
    /// <param name="reader">The reader.</param>
    /// <param name="endPoint">Where to listen.</param>
    /// <param name="options">Who may connect.</param>
    /// <exception cref="Server.BroadcasterException">The address or the port is not available.</exception>
    public static WebSocketOutlet Start(NeuronReader reader, IPEndPoint endPoint, WebSocketBroadcasterOptions options)
    {
        WebListener listener = WebListener.Create(endPoint);
        var broadcaster = new WebSocketBroadcaster(reader, options);
        listener.Application.MapNeuronWebSocket("/", broadcaster);
        try
        {
            listener.Start();
            return new WebSocketOutlet(listener, broadcaster, isOpen: options.Token is null && !IPAddress.IsLoopback(endPoint.Address));
        }
        catch
        {
            broadcaster.DisposeAsync().AsTask().GetAwaiter().GetResult();
            ((IDisposable)listener.Application).Dispose();
            throw;
        }
    }

    public override OutletFigures GetFigures()
    {
        WebSocketBroadcasterStatistics statistics = _broadcaster.GetStatistics();
        return new OutletFigures(statistics.FramesSent, statistics.FramesDropped + statistics.FramesMissed)
        {
            Clients = statistics.Clients,
            Bytes = statistics.BytesSent,
        };
    }

    // A client that left early is no fault of the relay.
    public override async Task<bool> FinishAsync(StandardStreams streams)
    {
        await DisposeAsync();
        if (_broadcaster.Completion.Exception is not { } failure)
            return true;

        await streams.ComplainAsync($"{Name}: {failure.GetBaseException().Message}");
        return false;
    }

    public override async ValueTask DisposeAsync()
    {
        await Task.WhenAny(_broadcaster.DisposeAsync().AsTask(), Task.Delay(WebListener.CloseTimeout));
        await _listener.DisposeAsync();
    }
}
