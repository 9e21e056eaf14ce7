using System.Net;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A web server with one address, for WebSocket clients.</summary>
internal sealed class WebSocketOutlet : Outlet
{
    private static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(3);

    // What Kestrel holds for each client that does not read: about two lines of JSON.
    private const int MostUnsent = 16 * 1024;

    private readonly WebApplication _application;
    private readonly WebSocketBroadcaster _broadcaster;
    private bool _isStopped;

    private WebSocketOutlet(WebApplication application, WebSocketBroadcaster broadcaster, IPEndPoint endPoint, bool isOpen)
    {
        (_application, _broadcaster) = (application, broadcaster);
        Name = $"{WebSocketDestination.Scheme}{new IPEndPoint(endPoint.Address, new Uri(application.Urls.Single()).Port)}";
        Announcement = $"Listening on {Name}{(isOpen ? ": anybody who reaches this port may connect; --token WORD limits it" : string.Empty)}";
    }

    public override string Name { get; }

    public override string Announcement { get; }

    public override string Unit => "frames";

    /// <summary>Starts to listen.</summary>
    /// <param name="reader">The reader.</param>
    /// <param name="endPoint">Where to listen.</param>
    /// <param name="options">Who may connect.</param>
    /// <exception cref="IOException">The port is in use.</exception>
    /// <exception cref="System.Net.Sockets.SocketException">The address or the port is not available.</exception>
    public static WebSocketOutlet Start(NeuronReader reader, IPEndPoint endPoint, WebSocketBroadcasterOptions options)
    {
        // Empty: files and variables of this computer that configure other web applications do not matter here.
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore().ConfigureKestrel(kestrel =>
        {
            kestrel.AddServerHeader = false;
            kestrel.Limits.MaxResponseBufferSize = MostUnsent;
            kestrel.Listen(endPoint);
        });
        builder.Services.Configure<SocketTransportOptions>(static transport => transport.MaxWriteBufferSize = MostUnsent);
        builder.Services.AddRoutingCore().AddSingleton<IHostLifetime, NoLifetime>();
        builder.Services.Configure<HostOptions>(static host => host.ShutdownTimeout = CloseTimeout);
        WebApplication application = builder.Build();
        var broadcaster = new WebSocketBroadcaster(reader, options);
        application.MapNeuronWebSocket("/", broadcaster);
        try
        {
            application.StartAsync().GetAwaiter().GetResult();
            return new WebSocketOutlet(application, broadcaster, endPoint, isOpen: options.Token is null && !IPAddress.IsLoopback(endPoint.Address));
        }
        catch
        {
            broadcaster.DisposeAsync().AsTask().GetAwaiter().GetResult();
            ((IDisposable)application).Dispose();
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
        await Task.WhenAny(_broadcaster.DisposeAsync().AsTask(), Task.Delay(CloseTimeout));

        // Kestrel sends what is left. Disposing it alone resets the connections.
        if (!_isStopped)
            await _application.StopAsync();

        _isStopped = true;
        await _application.DisposeAsync();
    }

    // The program itself decides when to end.
    private sealed class NoLifetime : IHostLifetime
    {
        public Task WaitForStartAsync(CancellationToken cancellationToken) => Task.CompletedTask;

        public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;
    }
}
