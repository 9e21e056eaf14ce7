using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.AspNetCore.Server.Kestrel.Transport.Sockets;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using NeuronMocap.Server;

namespace NeuronMocap.Tool.Listening;

/// <summary>A web server with one address, which only the program itself configures and ends.</summary>
internal sealed class WebListener : IAsyncDisposable
{
    /// <summary>The longest time that clients get at the end to take what is left.</summary>
    public static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(3);

    // What Kestrel holds for each client that does not read: about two lines of JSON.
    private const int MostUnsent = 16 * 1024;

    private readonly IPEndPoint _endPoint;
    private bool _isStopped;

    private WebListener(WebApplication application, IPEndPoint endPoint) => (Application, _endPoint) = (application, endPoint);

    /// <summary>The application. Map its addresses before <see cref="Start"/>.</summary>
    public WebApplication Application { get; }

    /// <summary>Where the server listens, with its real port. After <see cref="Start"/>.</summary>
    public IPEndPoint LocalEndPoint => new(_endPoint.Address, new Uri(Application.Urls.Single()).Port);

    /// <summary>Creates a server that does not listen yet.</summary>
    /// <param name="endPoint">Where to listen; port 0 for any free one.</param>
    /// <param name="limits">Sets limits of Kestrel; null for the defaults.</param>
    public static WebListener Create(IPEndPoint endPoint, Action<KestrelServerLimits>? limits = null)
    {
        // Empty: files and variables of this computer that configure other web applications do not matter here.
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore().ConfigureKestrel(kestrel =>
        {
            kestrel.AddServerHeader = false;
            kestrel.Limits.MaxResponseBufferSize = MostUnsent;
            limits?.Invoke(kestrel.Limits);
            kestrel.Listen(endPoint);
        });
        builder.Services.Configure<SocketTransportOptions>(static transport => transport.MaxWriteBufferSize = MostUnsent);
        builder.Services.AddRoutingCore().AddSingleton<IHostLifetime, NoLifetime>();
        builder.Services.Configure<HostOptions>(static host => host.ShutdownTimeout = CloseTimeout);
        return new WebListener(builder.Build(), endPoint);
    }

    /// <summary>Starts to listen.</summary>
    /// <exception cref="BroadcasterException">The address or the port is not available.</exception>
    public void Start()
    {
        try
        {
            Application.StartAsync().GetAwaiter().GetResult();
        }
        catch (Exception exception) when (exception is IOException or SocketException)
        {
            // Kestrel reports a port in use in its own way.
            SocketException cause = exception as SocketException ?? exception.InnerException as SocketException
                ?? new SocketException((int)(exception.InnerException is AddressInUseException ? SocketError.AddressAlreadyInUse : SocketError.SocketError));
            throw BroadcasterException.CannotListen(_endPoint, nameof(BroadcasterOptions.Port), cause);
        }
    }

    /// <summary>Ends the connections. Clients get a short time to take what is left.</summary>
    public async ValueTask DisposeAsync()
    {
        // Kestrel sends what is left. Disposing it alone resets the connections.
        if (!_isStopped)
            await Application.StopAsync();

        _isStopped = true;
        await Application.DisposeAsync();
    }

    // The program itself decides when to end.
    private sealed class NoLifetime : IHostLifetime
    {
        public Task WaitForStartAsync(CancellationToken cancellationToken) => Task.CompletedTask;

        public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;
    }
}
