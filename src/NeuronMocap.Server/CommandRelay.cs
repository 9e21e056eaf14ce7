using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server;

/// <summary>
/// Passes the command channel of another server on, beside a <see cref="Broadcaster"/> that relays its stream (manual sections 2.3.9 to 2.3.14).
/// </summary>
/// <remarks>
/// Each client gets its own connection to the server. Bytes pass unchanged in both directions, so commands that this library does not know work too. When one
/// side ends the connection, the other side sees the end. A connection that passes no bytes for <see cref="CommandRelayOptions.IdleTimeout"/> is closed.
/// <para>All members are thread-safe. One background thread listens; the connections use pool threads only while bytes pass.</para>
/// </remarks>
public sealed class CommandRelay : IDisposable, IAsyncDisposable
{
    private readonly FaultReport _report = new(nameof(CommandRelay));
    private readonly CommandRelayOptions _options;
    private readonly CommandPort _port;

    /// <summary>Creates a relay without starting it.</summary>
    /// <param name="options">The settings, which are copied.</param>
    /// <exception cref="ArgumentException">A setting is out of range, and the message names it.</exception>
    public CommandRelay(CommandRelayOptions options)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).CopyChecked();
        _port = new CommandPort(
            nameof(CommandRelay), "command relay", new IPEndPoint(_options.BindAddress, _options.Port), _options.MaxClients, CreateSession, _report);
    }

    // Tests replace it.
    internal Func<long> GetTimestamp { get; init; } = Stopwatch.GetTimestamp;

    /// <summary>Occurs when the server cannot be reached for a client. The argument says why.</summary>
    /// <remarks>
    /// The event is raised on a pool thread, after the client was disconnected. Other clients continue. Without a handler, the first exception goes to
    /// <see cref="Trace"/>. Exceptions that a handler throws are not raised.
    /// </remarks>
    public event Action<Exception>? Failed
    {
        add => _report.Failed += value;
        remove => _report.Failed -= value;
    }

    /// <summary>Address and real port where clients connect. Null before the start.</summary>
    public IPEndPoint? LocalEndPoint => _port.LocalEndPoint;

    /// <summary>Number of clients that are connected.</summary>
    public int ClientCount => _port.ClientCount;

    /// <summary>Opens the port and starts to listen. The server need not run yet.</summary>
    /// <exception cref="BroadcasterException">The port is not available. The relay can be started again.</exception>
    /// <exception cref="InvalidOperationException">The relay has already been started.</exception>
    /// <exception cref="ObjectDisposedException">The relay has been stopped.</exception>
    public void Start() => _port.Start();

    /// <summary>Closes all connections at once and ends the thread. Returns within seconds and can be called repeatedly.</summary>
    public void Stop() => _port.Dispose();

    /// <summary>Stops the relay, as <see cref="Stop"/> does.</summary>
    public void Dispose() => Stop();

    /// <summary>Stops the relay, as <see cref="Stop"/> does, without blocking the caller.</summary>
    /// <returns>A task that completes when everything is closed.</returns>
    public ValueTask DisposeAsync() => new(Task.Run(Stop));

    private CommandRelaySession CreateSession(Socket client) => new(client, _options, LocalEndPoint!, GetTimestamp, _port.OnEnded, _report);
}
