using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server;

/// <summary>
/// The command channel of a <see cref="Broadcaster"/> (manual sections 2.3.9 to 2.3.14, protocol.md section 6): a TCP port of its own, on which clients
/// ask for the rotation order, the sizes of the avatars' bodies and the beginning of their BVH files, and have avatars zeroed out,
/// which turns them to face front.
/// <para>
/// Answers with the broadcaster's settings and sources; an avatar that there is not gets 0, or an empty answer, and so does a command that is
/// not known. Nothing that a client sends ends the server or reaches another client: bytes that are no request are passed over, and a request that announces
/// too much closes its connection. All members may be used from any thread. One thread listens and every client has one, all in the background.
/// </para>
/// </summary>
public sealed class CommandServer : IDisposable, IAsyncDisposable
{
    private static readonly TimeSpan JoinTimeout = TimeSpan.FromSeconds(5);

    // A client that has just connected is about to ask, and one that was just answered often asks again.
    private static readonly long SafeTime = 2 * Stopwatch.Frequency;

    private readonly object _lock = new();
    private readonly FaultReport _report = new(nameof(CommandServer));
    private readonly CommandServerOptions _options;
    private readonly CommandAnswers _answers;
    private readonly List<CommandSession> _sessions = [];
    private readonly ManualResetEventSlim _stop = new();
    private ClientListener? _listener;
    private bool _hasEnded;

    /// <summary>Makes a server that does nothing yet.</summary>
    /// <param name="broadcaster">Whose avatars the commands are about; not started, stopped or disposed by the server.</param>
    /// <param name="options">The settings, copied; null for the defaults.</param>
    /// <exception cref="ArgumentException">A setting is out of its range; the message names it. Or the broadcaster plays a recording.</exception>
    public CommandServer(Broadcaster broadcaster, CommandServerOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(broadcaster);
        if (broadcaster.Plan is not { } plan)
            throw new ArgumentException("A recording does not say what a command channel answers.", nameof(broadcaster));

        _answers = new CommandAnswers(plan, broadcaster.FrameRate, broadcaster.ZeroOut, broadcaster.ZeroOutAll);
        _options = (options ?? new CommandServerOptions()).CopyChecked();
    }

    // Replaced by tests.
    internal Func<long> GetTimestamp { get; init; } = Stopwatch.GetTimestamp;

    /// <summary>
    /// Raised, on a thread of the server, with what a source threw when a command was to be answered. The connection of the client that asked is closed; the
    /// server and its other clients go on. Without a handler the first exception goes to <see cref="Trace"/>. What a handler throws is not raised.
    /// </summary>
    public event Action<Exception>? Failed
    {
        add => _report.Failed += value;
        remove => _report.Failed -= value;
    }

    /// <summary>Where clients connect, with the real port; null before the start.</summary>
    public IPEndPoint? LocalEndPoint { get; private set; }

    /// <summary>Clients that are connected now.</summary>
    public int ClientCount
    {
        get
        {
            lock (_lock)
                return _sessions.Count;
        }
    }

    /// <summary>Takes the port and begins to listen.</summary>
    /// <exception cref="BroadcasterException">The port cannot be had. The server can be started again.</exception>
    /// <exception cref="InvalidOperationException">It was started before.</exception>
    /// <exception cref="ObjectDisposedException">It was stopped before.</exception>
    public void Start()
    {
        lock (_lock)
        {
            if (_hasEnded)
                throw new ObjectDisposedException(nameof(CommandServer), "The command server was stopped.");
            if (_listener is not null)
                throw new InvalidOperationException("The command server was started before.");

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
            _listener.Worker.Start();
        }
    }

    /// <summary>Closes all connections at once and ends all threads. Returns within seconds; may be repeated.</summary>
    public void Stop()
    {
        Worker?[] workers;
        lock (_lock)
        {
            _hasEnded = true;
            _stop.Set();
            _listener?.Dispose();
            workers = [_listener?.Worker, .. _sessions.ConvertAll(session => session.Worker)];
            _sessions.ForEach(session => session.Dispose());
        }

        long deadline = Stopwatch.GetTimestamp() + (long)(JoinTimeout.TotalSeconds * Stopwatch.Frequency);
        foreach (Worker? worker in workers)
            worker?.Join(deadline);
    }

    /// <summary>Does what <see cref="Stop"/> does.</summary>
    public void Dispose() => Stop();

    /// <summary>Does what <see cref="Stop"/> does, without blocking the caller.</summary>
    /// <returns>Ends when all is closed.</returns>
    public ValueTask DisposeAsync() => new(Task.Run(Stop));

    private void OnAccepted(Socket socket)
    {
        lock (_lock)
        {
            if (_hasEnded || (CountClients() >= _options.MaxClients && !TryMakeRoom()))
            {
                socket.Dispose();
                return;
            }

            try
            {
                var session = new CommandSession(socket, _answers, _options, GetTimestamp, _stop, OnEnded, _report);
                session.Worker.Start();
                _sessions.Add(session);
            }
            catch (Exception exception) when (exception is SocketException or OutOfMemoryException)
            {
                // It was reset before it was greeted, or the system has no thread left for it.
                socket.Dispose();
            }
        }
    }

    // A client that connects anew has closed its old connection, whose session may not have had time to notice. Only a full server has to look.
    private int CountClients() => _sessions.Count < _options.MaxClients ? _sessions.Count : _sessions.Count(static session => !session.IsLeft);

    // Whoever never asked gives way before whoever did: connections that only take up room push out each other.
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

    private void OnEnded(CommandSession session)
    {
        lock (_lock)
            _sessions.Remove(session);
    }
}
