using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server;

/// <summary>
/// Serves the command channel of a <see cref="Broadcaster"/> on its own TCP port (manual sections 2.3.9 to 2.3.14, protocol.md section 6).
/// </summary>
/// <remarks>
/// Clients ask for the rotation order, the body sizes of avatars and the beginning of their BVH files. They can also zero out avatars, which turns
/// them to face front. The answers come from the settings and sources of the broadcaster. For an avatar that does not exist, and for an unknown
/// command, the answer is 0 or empty.
/// <para>
/// A client can neither end the server nor affect another client. Bytes that are not a request are skipped. A request that announces too
/// many bytes closes its connection.
/// </para>
/// <para>All members are thread-safe. One background thread listens, and each client has a background thread.</para>
/// </remarks>
public sealed class CommandServer : IDisposable, IAsyncDisposable
{
    // A client that has just connected is about to send a request. A client that has just been answered often sends another.
    private static readonly long SafeTime = 2 * Stopwatch.Frequency;

    private readonly object _lock = new();
    private readonly FaultReport _report = new(nameof(CommandServer));
    private readonly CommandServerOptions _options;
    private readonly CommandAnswers _answers;
    private readonly List<CommandSession> _sessions = [];
    private readonly WorkerList _workers = new();
    private readonly ManualResetEventSlim _stop = new();
    private ClientListener? _listener;
    private bool _hasEnded;

    /// <summary>Creates a server without starting it.</summary>
    /// <param name="broadcaster">The broadcaster whose avatars the commands concern. The server does not start, stop or dispose it.</param>
    /// <param name="options">The settings, which are copied; null for the defaults.</param>
    /// <exception cref="ArgumentException">
    /// A setting is out of range, and the message names it. Or the broadcaster has no sources: it sends a recording, or what a reader receives.
    /// </exception>
    public CommandServer(Broadcaster broadcaster, CommandServerOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(broadcaster);
        if (broadcaster.Plan is not { } plan)
            throw new ArgumentException("A command server needs a broadcaster with sources. Use a CommandRelay beside a broadcaster with a Reader.", nameof(broadcaster));

        _answers = new CommandAnswers(plan, broadcaster.FrameRate, broadcaster.ZeroOut, broadcaster.ZeroOutAll);
        _options = (options ?? new CommandServerOptions()).CopyChecked();
    }

    // Tests replace it.
    internal Func<long> GetTimestamp { get; init; } = Stopwatch.GetTimestamp;

    /// <summary>Occurs when a source throws while the server answers a command. The argument is the exception.</summary>
    /// <remarks>
    /// The event is raised on a thread of the server. The server closes the connection of the client that sent the command; the server and its other
    /// clients continue. Without a handler, the first exception goes to <see cref="Trace"/>. Exceptions that a handler throws are not raised.
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

    /// <summary>Opens the port and starts to listen.</summary>
    /// <exception cref="BroadcasterException">The port is not available. The server can be started again.</exception>
    /// <exception cref="InvalidOperationException">The server has already been started.</exception>
    /// <exception cref="ObjectDisposedException">The server has been stopped.</exception>
    public void Start()
    {
        lock (_lock)
        {
            if (_hasEnded)
                throw new ObjectDisposedException(nameof(CommandServer), "The command server has been stopped.");
            if (_listener is not null)
                throw new InvalidOperationException("The command server has already been started.");

            var endPoint = new IPEndPoint(_options.BindAddress, _options.Port);
            try
            {
                _listener = new ClientListener(endPoint, OnAccepted, _report);
            }
            catch (SocketException exception)
            {
                throw BroadcasterException.CannotListen(endPoint, nameof(CommandServerOptions.Port), exception);
            }

            LocalEndPoint = _listener.LocalEndPoint;
            Launch(_listener.Worker);
        }
    }

    /// <summary>Closes all connections at once and ends all threads. Returns within seconds and can be called repeatedly.</summary>
    public void Stop()
    {
        Worker[] workers;
        lock (_lock)
        {
            _hasEnded = true;
            _stop.Set();
            _listener?.Dispose();
            _sessions.ForEach(session => session.Dispose());
            workers = _workers.ToArray();
        }

        WorkerList.Join(workers);
    }

    /// <summary>Stops the server, as <see cref="Stop"/> does.</summary>
    public void Dispose() => Stop();

    /// <summary>Stops the server, as <see cref="Stop"/> does, without blocking the caller.</summary>
    /// <returns>A task that completes when everything is closed.</returns>
    public ValueTask DisposeAsync() => new(Task.Run(Stop));

    // Serves a connection that another server accepted. The port need not be open. The task ends when the client is no longer served. Returns
    // false if there is no place for it. The caller then ends the connection.
    internal bool TryServe(ClientTransport transport, out Task served)
    {
        var completion = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        served = completion.Task;
        return TryServe(() => transport, () => completion.TrySetResult(true));
    }

    private void OnAccepted(Socket socket)
    {
        if (!TryServe(() => new SocketTransport(socket, CommandSession.SendTimeout), ended: null))
            socket.Dispose();
    }

    private bool TryServe(Func<ClientTransport> open, Action? ended)
    {
        lock (_lock)
        {
            if (_hasEnded || (CountClients() >= _options.MaxClients && !TryMakeRoom()))
                return false;

            try
            {
                var session = new CommandSession(open(), _answers, _options, GetTimestamp, _stop, session => OnEnded(session, ended), _report);
                Launch(session.Worker);
                _sessions.Add(session);
                return true;
            }
            catch (Exception exception) when (exception is SocketException or OutOfMemoryException)
            {
                // The client reset the connection before it was served, or the system cannot create a thread.
                return false;
            }
        }
    }

    // A client that reconnects has closed its old connection, but the old session may not have noticed yet. Only a full server needs to check.
    private int CountClients() => _sessions.Count < _options.MaxClients ? _sessions.Count : _sessions.Count(static session => !session.IsLeft);

    // Clients that never sent a request give way before clients that did. Connections that only take up room displace each other.
    private bool TryMakeRoom()
    {
        CommandSession? oldest = _sessions
            .Where(static session => session.Idle.Elapsed > SafeTime)
            .OrderBy(static session => session.Idle.HasAsked)
            .ThenByDescending(static session => session.Idle.Elapsed)
            .FirstOrDefault();
        if (oldest is null)
            return false;

        _sessions.Remove(oldest);
        oldest.Dispose();
        return true;
    }

    private void Launch(Worker worker)
    {
        worker.Start();
        _workers.Add(worker);
    }

    private void OnEnded(CommandSession session, Action? ended)
    {
        lock (_lock)
            _sessions.Remove(session);

        ended?.Invoke();
    }
}
