using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>The port of a command server or relay: it listens, keeps the sessions, and ends them. Thread-safe.</summary>
/// <param name="owner">The class that the port belongs to.</param>
/// <param name="description">The same in words, for messages.</param>
/// <param name="endPoint">Where to listen. Port 0 takes any free port.</param>
/// <param name="maxClients">Maximum number of sessions.</param>
/// <param name="create">Creates the session of a client. The session then owns the socket, and calls <see cref="OnEnded"/> once at its end.</param>
/// <param name="report">Receives unexpected exceptions of the listener.</param>
internal sealed class CommandPort(
    string owner, string description, IPEndPoint endPoint, int maxClients, Func<Socket, ICommandSession> create, FaultReport report) : IDisposable
{
    // Both options of the public classes have this name.
    private const string Setting = nameof(CommandServerOptions.Port);

    // A client that has just connected is about to send a request. A client that has just been answered often sends another.
    private static readonly long SafeTime = 2 * Stopwatch.Frequency;

    private readonly object _lock = new();
    private readonly List<ICommandSession> _sessions = [];
    private readonly WorkerList _workers = new();
    private ClientListener? _listener;
    private bool _hasEnded;

    // Null before the start.
    public IPEndPoint? LocalEndPoint { get; private set; }

    public int ClientCount
    {
        get
        {
            lock (_lock)
                return _sessions.Count;
        }
    }

    public void Start()
    {
        lock (_lock)
        {
            if (_hasEnded)
                throw new ObjectDisposedException(owner, $"The {description} has been stopped.");
            if (_listener is not null)
                throw new InvalidOperationException($"The {description} has already been started.");

            try
            {
                _listener = new ClientListener(endPoint, OnAccepted, report);
            }
            catch (SocketException exception)
            {
                throw BroadcasterException.CannotListen(endPoint, Setting, exception);
            }

            LocalEndPoint = _listener.LocalEndPoint;
            _listener.Worker.Start();
            _workers.Add(_listener.Worker);
        }
    }

    // Closes all connections, and waits for the threads for a limited time. Can be called repeatedly.
    public void Dispose()
    {
        Worker[] workers;
        lock (_lock)
        {
            _hasEnded = true;
            _listener?.Dispose();
            _sessions.ForEach(static session => session.Dispose());
            workers = _workers.ToArray();
        }

        WorkerList.Join(workers);
    }

    public void OnEnded(ICommandSession session)
    {
        lock (_lock)
            _sessions.Remove(session);
    }

    // Starts a session, of this port or of a connection that another server accepted. Returns false if there is no place for it. The caller then ends the
    // connection.
    public bool TryServe(Func<ICommandSession> open)
    {
        lock (_lock)
        {
            if (_hasEnded || (CountClients() >= maxClients && !TryMakeRoom()))
                return false;

            ICommandSession? session = null;
            try
            {
                session = open();
                _sessions.Add(session);
                if (session.Start() is { } worker)
                    _workers.Add(worker);

                return true;
            }
            catch (Exception exception) when (exception is SocketException or OutOfMemoryException)
            {
                // The client reset the connection before it was served, or the system cannot create a thread.
                if (session is not null)
                    _sessions.Remove(session);
                return false;
            }
        }
    }

    private void OnAccepted(Socket socket)
    {
        if (!TryServe(() => create(socket)))
            socket.Dispose();
    }

    // A client that reconnects has closed its old connection, but the old session may not have noticed yet. Only a full port needs to check.
    private int CountClients() => _sessions.Count < maxClients ? _sessions.Count : _sessions.Count(static session => !session.IsLeft);

    // Clients that never sent a request give way before clients that did. Connections that only take up room displace each other.
    private bool TryMakeRoom()
    {
        ICommandSession? oldest = _sessions
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
}
