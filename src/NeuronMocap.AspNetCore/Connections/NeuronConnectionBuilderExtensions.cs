using Microsoft.AspNetCore.Connections;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Logging.Abstractions;
using NeuronMocap;
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
    /// <param name="calculation">
    /// Whether clients get calculation packets only, like those of <see cref="BroadcasterOptions.CalculationPort"/>, which the broadcaster's options must then set.
    /// Readers connect to this address as their <see cref="NeuronReaderOptions.CalculationPort"/>.
    /// </param>
    /// <returns>The same builder.</returns>
    /// <exception cref="ArgumentException">The broadcaster has no separate calculation data.</exception>
    public static IConnectionBuilder UseNeuronBroadcast(this IConnectionBuilder listen, Broadcaster broadcaster, bool calculation = false)
    {
        ArgumentNullException.ThrowIfNull(listen);
        ArgumentNullException.ThrowIfNull(broadcaster);
        if (calculation && !broadcaster.HasCalculationStream)
            throw new ArgumentException("The broadcaster sends calculation data with the motion. Set BroadcasterOptions.CalculationPort, to 0 if Port is null.", nameof(calculation));

        return Use(listen, (ClientTransport transport, out Task served) => broadcaster.TryServe(transport, calculation, out served), broadcaster.ClientTimeout);
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
