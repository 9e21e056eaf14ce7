using System.Net;
using System.Security.Cryptography;
using Microsoft.AspNetCore.Builder;
using NeuronMocap.Server;
using NeuronMocap.Tool.Listening;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View;

/// <summary>The web server of the page.</summary>
internal sealed class ViewServer : IAsyncDisposable
{
    private const int TokenBytes = 16;
    private const int PortsToTry = 20;

    private readonly WebListener _listener;

    private ViewServer(WebListener listener, string? token) => (_listener, Token) = (listener, token);

    /// <summary>The word that browsers must send; null for none.</summary>
    public string? Token { get; }

    /// <summary>Where the server listens.</summary>
    public IPEndPoint LocalEndPoint => _listener.LocalEndPoint;

    /// <summary>Starts to listen.</summary>
    /// <param name="options">Where to listen, and who may connect.</param>
    /// <param name="parts">What the server serves besides the page. Their owner disposes them.</param>
    /// <exception cref="BroadcasterException">The address or the port is not available.</exception>
    public static async Task<ViewServer> StartAsync(ViewOptions options, IReadOnlyList<IViewPart> parts)
    {
        string? token = options.Token ?? (options.NeedsToken ? System.Convert.ToHexStringLower(RandomNumberGenerator.GetBytes(TokenBytes)) : null);
        var policy = new AccessPolicy(token, isRandom: options.Token is null, options.IsPublic, options.AllowedOrigins);
        for (int port = options.Port ?? ViewOptions.DefaultPort; ; port++)
        {
            WebListener listener = WebListener.Create(new IPEndPoint(options.Bind, port), static limits => limits.MaxRequestBodySize = RequestGuard.UsualBody);
            listener.Application.UseGuard(policy);
            listener.Application.UseRouting();
            PageFiles.Map(listener.Application);
            foreach (IViewPart part in parts)
                part.Map(listener.Application);

            try
            {
                listener.Start();
                return new ViewServer(listener, token);
            }
            catch (BroadcasterException exception)
            {
                await listener.Application.DisposeAsync();
                bool mayTryNext = options.Port is null && port < ViewOptions.DefaultPort + PortsToTry && exception.Setting is nameof(BroadcasterOptions.Port);
                if (!mayTryNext)
                    throw;
            }
        }
    }

    public ValueTask DisposeAsync() => _listener.DisposeAsync();
}
