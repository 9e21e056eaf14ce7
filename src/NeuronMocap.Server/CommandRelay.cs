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
/// side ends the connection, the other side sees the end.
/// <para>All members are thread-safe. One background thread listens; the connections use pool threads only while bytes pass.</para>
/// </remarks>
public sealed class CommandRelay : IDisposable, IAsyncDisposable
{
    private readonly object _lock = new();
    private readonly FaultReport _report = new(nameof(CommandRelay));
    private readonly CommandRelayOptions _options;
    private readonly List<CommandRelaySession> _sessions = [];
    private ClientListener? _listener;
    private bool _hasEnded;

    /// <summary>Creates a relay without starting it.</summary>
    /// <param name="options">The settings, which are copied.</param>
    /// <exception cref="ArgumentException">A setting is out of range, and the message names it.</exception>
    public CommandRelay(CommandRelayOptions options) =>
        _options = (options ?? throw new ArgumentNullException(nameof(options))).CopyChecked();

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
    public IPEndPoint? LocalEndPoint { get; private set; }

    /// <summary>Number of clients that are connected.</summary>
    public int ClientCount
    {
        get
        {
            lock (_lock)
                return _sessions.Count;
        }
    }

    /// <summary>Opens the port and starts to listen. The server need not run yet.</summary>
    /// <exception cref="BroadcasterException">The port is not available. The relay can be started again.</exception>
    /// <exception cref="InvalidOperationException">The relay has already been started.</exception>
    /// <exception cref="ObjectDisposedException">The relay has been stopped.</exception>
    public void Start()
    {
        lock (_lock)
        {
            if (_hasEnded)
                throw new ObjectDisposedException(nameof(CommandRelay), "The command relay has been stopped.");
            if (_listener is not null)
                throw new InvalidOperationException("The command relay has already been started.");

            var endPoint = new IPEndPoint(_options.BindAddress, _options.Port);
            try
            {
                _listener = new ClientListener(endPoint, OnAccepted, _report);
            }
            catch (SocketException exception)
            {
                throw BroadcasterException.CannotListen(endPoint, nameof(CommandRelayOptions.Port), exception);
            }

            LocalEndPoint = _listener.LocalEndPoint;
            _listener.Worker.Start();
        }
    }

    /// <summary>Closes all connections at once and ends the thread. Returns within seconds and can be called repeatedly.</summary>
    public void Stop()
    {
        lock (_lock)
        {
            _hasEnded = true;
            _listener?.Dispose();
            _sessions.ForEach(static session => session.Dispose());
        }

        if (_listener is { } listener)
            WorkerList.Join([listener.Worker]);
    }

    /// <summary>Stops the relay, as <see cref="Stop"/> does.</summary>
    public void Dispose() => Stop();

    /// <summary>Stops the relay, as <see cref="Stop"/> does, without blocking the caller.</summary>
    /// <returns>A task that completes when everything is closed.</returns>
    public ValueTask DisposeAsync() => new(Task.Run(Stop));

    private void OnAccepted(Socket client)
    {
        CommandRelaySession session;
        lock (_lock)
        {
            if (_hasEnded || _sessions.Count >= _options.MaxClients)
            {
                client.Dispose();
                return;
            }

            session = new CommandRelaySession(client, _options, LocalEndPoint!);
            _sessions.Add(session);
        }

        _ = RunAsync(session);
    }

    private async Task RunAsync(CommandRelaySession session)
    {
        Exception? failure = null;
        try
        {
            await session.RunAsync().ConfigureAwait(false);
        }
        catch (Exception exception)
        {
            failure = exception;
        }

        bool isStopping;
        lock (_lock)
        {
            _sessions.Remove(session);
            isStopping = _hasEnded;
        }

        session.Dispose();
        if (failure is not null && !isStopping)
            _report.Report(failure);
    }
}
