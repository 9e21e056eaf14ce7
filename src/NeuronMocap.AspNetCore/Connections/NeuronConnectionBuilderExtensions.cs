using Microsoft.AspNetCore.Connections;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Logging.Abstractions;
using NeuronMocap.AspNetCore.Connections;
using NeuronMocap.Server;
using NeuronMocap.Server.Clients;

namespace Microsoft.AspNetCore.Hosting;

/// <summary>Lets Kestrel accept the clients of a motion server, with the TLS, limits and logs of Kestrel.</summary>
/// <remarks>
/// Call these methods last for an address, after <c>UseHttps</c>. Clients connect as to Axis Neuron. An address of Kestrel serves either motion, or commands, or HTTP.
/// </remarks>
public static class NeuronConnectionBuilderExtensions
{
    private const string Category = "NeuronMocap.AspNetCore";

    /// <summary>Serves the clients of this address from a broadcaster, like those of <see cref="BroadcasterOptions.Port"/>.</summary>
    /// <param name="listen">The address, in the configuration of Kestrel.</param>
    /// <param name="broadcaster">
    /// The broadcaster. Its owner starts it before clients connect, and disposes it. It needs no port of its own: set <see cref="BroadcasterOptions.Port"/> to null.
    /// <see cref="BroadcasterOptions.MaxClients"/> and <see cref="BroadcasterOptions.ClientTimeout"/> apply to these clients, too.
    /// </param>
    /// <returns>The same builder.</returns>
    public static IConnectionBuilder UseNeuronBroadcast(this IConnectionBuilder listen, Broadcaster broadcaster)
    {
        ArgumentNullException.ThrowIfNull(listen);
        ArgumentNullException.ThrowIfNull(broadcaster);
        return Use(listen, broadcaster.TryServe, broadcaster.ClientTimeout);
    }

    /// <summary>Serves the clients of this address from a command server, like those of <see cref="CommandServerOptions.Port"/>.</summary>
    /// <param name="listen">The address, in the configuration of Kestrel.</param>
    /// <param name="commands">
    /// The command server, which its owner disposes. Without <see cref="CommandServer.Start"/> it has no port of its own. Readers do not encrypt the connection for
    /// commands.
    /// </param>
    /// <returns>The same builder.</returns>
    public static IConnectionBuilder UseNeuronCommands(this IConnectionBuilder listen, CommandServer commands)
    {
        ArgumentNullException.ThrowIfNull(listen);
        ArgumentNullException.ThrowIfNull(commands);
        return Use(listen, commands.TryServe, CommandSession.SendTimeout);
    }

    private static IConnectionBuilder Use(IConnectionBuilder listen, Serve serve, TimeSpan sendTimeout)
    {
        ILoggerFactory loggers = listen.ApplicationServices.GetService<ILoggerFactory>() ?? NullLoggerFactory.Instance;
        return listen.Run(new NeuronConnectionHandler(serve, sendTimeout, loggers.CreateLogger(Category)).RunAsync);
    }
}
