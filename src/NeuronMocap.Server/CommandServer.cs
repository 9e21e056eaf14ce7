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
    private readonly FaultReport _report = new(nameof(CommandServer));
    private readonly CommandServerOptions _options;
    private readonly CommandAnswers _answers;
    private readonly CommandPort _port;
    private readonly ManualResetEventSlim _stop = new();

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
        _port = new CommandPort(
            nameof(CommandServer), "command server", new IPEndPoint(_options.BindAddress, _options.Port), _options.MaxClients, CreateSession, _report);
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
    public IPEndPoint? LocalEndPoint => _port.LocalEndPoint;

    /// <summary>Number of clients that are connected.</summary>
    public int ClientCount => _port.ClientCount;

    /// <summary>Opens the port and starts to listen.</summary>
    /// <exception cref="BroadcasterException">The port is not available. The server can be started again.</exception>
    /// <exception cref="InvalidOperationException">The server has already been started.</exception>
    /// <exception cref="ObjectDisposedException">The server has been stopped.</exception>
    public void Start() => _port.Start();

    /// <summary>Closes all connections at once and ends all threads. Returns within seconds and can be called repeatedly.</summary>
    public void Stop()
    {
        _stop.Set();
        _port.Dispose();
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
        return _port.TryServe(() => CreateSession(transport, OnEnded));

        void OnEnded(ICommandSession session)
        {
            _port.OnEnded(session);
            completion.TrySetResult(true);
        }
    }

    private CommandSession CreateSession(Socket socket) => CreateSession(new SocketTransport(socket, CommandSession.SendTimeout), _port.OnEnded);

    private CommandSession CreateSession(ClientTransport transport, Action<ICommandSession> ended) =>
        new(transport, _answers, _options, GetTimestamp, _stop, ended, _report);
}
