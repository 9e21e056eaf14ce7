using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using NeuronMocap.Commands;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Telemetry;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>Receives the motion capture stream of Axis Neuron, Axis Studio or a simulator, and delivers its frames to the application.</summary>
/// <remarks>
/// <para>Make a reader, choose how to receive frames, start it, and dispose it at the end. There are five ways to receive frames:</para>
/// <list type="bullet">
/// <item><description><see cref="OpenQueue(int, string)"/> delivers every frame to one thread when it asks for frames, as in a main loop.</description></item>
/// <item><description><see cref="OpenLatest"/> delivers the newest frame of each avatar, as for a renderer.</description></item>
/// <item><description><see cref="OpenDelivery"/> calls handlers on a window's thread.</description></item>
/// <item><description>
/// <see cref="MotionReceived"/>, <see cref="CalculationReceived"/> and <see cref="StudioCalculationReceived"/> call a handler on the receive thread. This
/// is the shortest way.
/// </description></item>
/// <item><description><see cref="ReadMotionAsync(CancellationToken)"/> and its variants are for code that awaits.</description></item>
/// </list>
/// <para>
/// You can mix them, and open and close them while the reader runs. The first four allocate nothing per frame.
/// </para>
/// <para>
/// A reader has one connection or one UDP port, and a second one if <see cref="NeuronReaderOptions.CalculationPort"/> is set. It can also receive from a
/// stream, a <see cref="ByteSource"/> or a file. A program can have any number of readers. All members are thread-safe.
/// </para>
/// <para>
/// A running reader stays alive, with its connection and its handlers, even if nothing in the program refers to it. It ends when it is disposed. If
/// reconnecting is off, it also ends with its connection. A reader that was never started, or has ended, is garbage-collected like any object.
/// </para>
/// </remarks>
public sealed partial class NeuronReader : IDisposable, IAsyncDisposable
{
    private readonly NeuronReaderOptions _options;
    private readonly CancellationTokenSource _stopSource = new();
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly TaskCompletionSource<bool> _stopped = new();
    private readonly TaskCompletionSource<bool> _connected = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly FrameFormat _format;
    private readonly ReaderMetrics _metrics;
    private readonly ReceivePipeline _pipeline;
    private readonly HandlerList<ReaderEvent> _eventHandlers;
    private readonly EventReporter _reporter;
    private readonly HandlerList<ConnectionStatus> _statusHandlers;
    private readonly StatusPublisher _status;
    private readonly LinkActivity _activity;
    private readonly SenderFilter _senders;

    // Each port has a filter of its own, because the status of a port tells what was refused there.
    private readonly SenderFilter _calculationSenders;
    private readonly ConnectionSupervisor _supervisor;
    private readonly UdpServers? _servers;
    private readonly object? _receiveLock;
    private readonly CombinedStatus? _combinedStatus;
    private readonly CalculationConnection? _calculation;
    private readonly ServerDiscovery? _discovery;
    private readonly ReaderRecordings _recordings;
    private readonly RecordingPlayer? _player;
    private Watchdog? _watchdog;
    private int _started;
    private int _begun;
    private int _disposed;
    private int _reportingThread;
    private int _failureTraced;

    /// <summary>Creates a reader for a TCP server.</summary>
    /// <param name="host">Name or address of the computer that runs Axis Neuron.</param>
    /// <param name="port">The server's port, 1 to 65535.</param>
    /// <exception cref="ArgumentException">The host is empty, or the port is out of range.</exception>
    public NeuronReader(string host, int port = ProtocolConstants.DefaultPort)
        : this(new NeuronReaderOptions { Host = host, Port = port })
    {
    }

    /// <summary>Creates a reader.</summary>
    /// <param name="options">Where and how to receive; copied.</param>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public NeuronReader(NeuronReaderOptions options)
        : this(options, createLink: null)
    {
    }

    /// <summary>Creates a reader that receives from a file instead of a live stream.</summary>
    /// <param name="player">
    /// Plays the file when the reader starts. A player can have only one reader, and the reader does not dispose it.
    /// </param>
    /// <param name="options">
    /// How to receive; copied; null for the defaults. Options of a connection have no effect: server, port, senders, reconnecting and command port. The
    /// largest number of values is that of the player. The rotation order and the skeleton variant override those of the player.
    /// </param>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    /// <exception cref="InvalidOperationException">The player already has a reader.</exception>
    /// <exception cref="ObjectDisposedException">The player was disposed.</exception>
    public NeuronReader(RecordingPlayer player, NeuronReaderOptions? options = null)
        : this(options ?? new NeuronReaderOptions(), createLink: null, player ?? throw new ArgumentNullException(nameof(player)))
    {
    }

    /// <summary>Creates a reader for a stream of bytes that is already open, such as a serial port, a tunnel or a program's output.</summary>
    /// <remarks>
    /// The reader ends when the stream ends or fails, whatever its reconnect policy says. To reconnect, set <see cref="NeuronReaderOptions.Source"/>. On
    /// .NET, the reader calls <c>ReadAsync</c>; with <see cref="ReceiveThread.Dedicated"/>, and on .NET Standard, it calls <c>Read</c> on a thread of its
    /// own.
    /// </remarks>
    /// <param name="stream">Delivers the bytes that a server would send over TCP. Nothing else may read it while the reader runs.</param>
    /// <param name="options">How to receive; copied; null for the defaults. Its <see cref="NeuronReaderOptions.Source"/> has no effect.</param>
    /// <param name="leaveOpen">
    /// False to dispose the stream when the reader ends. True to leave it open; a read that is pending then continues, and its bytes are lost.
    /// </param>
    /// <exception cref="ArgumentException">The stream cannot be read, or an option is out of range; the message names it.</exception>
    public NeuronReader(Stream stream, NeuronReaderOptions? options = null, bool leaveOpen = false)
        : this((options ?? new NeuronReaderOptions()).CopyFor(SingleStreamSource.Of(stream, leaveOpen)), createLink: null)
    {
    }

    internal NeuronReader(NeuronReaderOptions options, Func<Link>? createLink)
        : this(options, createLink, player: null)
    {
    }

    private NeuronReader(NeuronReaderOptions options, Func<Link>? createLink, RecordingPlayer? player)
    {
        ArgumentNullException.ThrowIfNull(options);
        _player = player;
        _options = player is null ? options.Copy() : options.CopyFor(player);
        if (_options.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        _statusHandlers = new HandlerList<ConnectionStatus>(OnCallbackFailed);
        if (_options.CalculationLink is { } second)
        {
            _receiveLock = new object();
            _servers = new UdpServers();
            _combinedStatus = new CombinedStatus(OnStatusChanged, second.Port);
        }

        _status = new StatusPublisher(OnFirstStatusChanged);
        _senders = new SenderFilter(_options.AllowedSenders);
        _calculationSenders = new SenderFilter(_options.AllowedSenders);
        Func<Link>? playback = player?.Attach(_senders, OnCallbackFailed);
        _format = player?.CreateFormat(_options.RotationOrder, _options.SkeletonVariant) ?? _options.Format;
        _discovery = _options.Commands is { } commands ? new ServerDiscovery(commands, _format, OnFormatLearnt) : null;
        var recognizer = new StreamRecognizer(_format);
        _activity = new LinkActivity(
            _status,
            _options.SilenceTimeout,
            _options.Transport == TransportKind.Udp ? _senders : null,
            recognizer.Describe,
            player is null ? null : () => player.IsHeld,
            player is not null ? ConnectionMessages.NoRecordedFrames : _options.Source is not null ? ConnectionMessages.NoBytes : null);
        _activity.Disturbed = () => _watchdog?.Adjust();
        _eventHandlers = new HandlerList<ReaderEvent>(OnCallbackFailed);
        _eventHandlers.Add(_options.CreateLog());
        _metrics = new ReaderMetrics(_options.DisplayName);
        ReconnectPolicy reconnect = player is null ? _options.Reconnect : ReconnectPolicy.AtOnce;
        _supervisor = new ConnectionSupervisor(createLink ?? playback ?? CreateLink, reconnect, _status, _activity, new Random().NextDouble);
        _recordings = new ReaderRecordings(_options, _metrics.Name, _receiveLock)
        {
            IsObserved = () => !_eventHandlers.IsEmpty,
            Report = () => _reporter!.Check(Stopwatch.GetTimestamp()),
        };
        if (_discovery is not null)
        {
            _discovery.SizesLearnt = _recordings.Learn;
            _recordings.Started = _discovery.WantSizes;
        }

        _pipeline = new ReceivePipeline(
            _format, recognizer, _activity, _status, [_senders, _calculationSenders], _metrics, _supervisor.TrySend, _recordings, OnCallbackFailed, player is null ? null : player.MayWait, _receiveLock);
        if (_combinedStatus is not null)
            _calculation = CreateCalculationConnection(_options.CalculationLink!, _combinedStatus);

        _reporter = new EventReporter(_metrics.Name, _pipeline, _eventHandlers.Invoke) { EndTimeout = _options.StopTimeout / 2 };
    }

    /// <summary>Occurs when the state of the connection changes; calls are in order and one at a time.</summary>
    /// <remarks>
    /// Handlers run on a thread of the reader or of the pool. If a reader was never started, they run on the thread that disposes it. A handler can call
    /// any member, <see cref="Dispose"/> included, but should not take long.
    /// </remarks>
    public event Action<ConnectionStatus>? StatusChanged
    {
        add => _statusHandlers.Add(value);
        remove => _statusHandlers.Remove(value);
    }

    /// <summary>
    /// Occurs when a handler of one of this reader's events throws an exception, on the thread that called the handler.
    /// </summary>
    /// <remarks>
    /// <para>
    /// The exception ends here: other handlers and the connection continue. Exceptions from handlers of this event are only counted.
    /// </para>
    /// <para>
    /// If this event, <see cref="EventReported"/> and a log are all unused, the reader writes its first exception to <see cref="Trace"/>.
    /// <see cref="ReaderStatistics.CallbackFailures"/> always counts all exceptions.
    /// </para>
    /// </remarks>
    public event Action<Exception>? CallbackFailed;

    /// <summary>Occurs for everything that deserves a line in a log.</summary>
    /// <remarks>
    /// <list type="bullet">
    /// <item><description>Changes of the connection's state are reported at once, on the thread that publishes them.</description></item>
    /// <item><description>
    /// Lost and dropped frames, skipped bytes and failed handlers are reported on a pool thread. The first of each kind is reported within half a second;
    /// later ones are combined into one event every 10 s.
    /// </description></item>
    /// <item><description>Starts and losses of recordings and exports are reported on a pool thread too.</description></item>
    /// <item><description>Ends of recordings and exports are reported at once, on their own thread.</description></item>
    /// </list>
    /// <para>
    /// These threads may call handlers at the same time, but each of them makes one call at a time. On .NET, <c>NeuronReaderOptions.LoggerFactory</c> gets
    /// the same events.
    /// </para>
    /// </remarks>
    public event Action<ReaderEvent>? EventReported
    {
        add => _eventHandlers.Add(value);
        remove => _eventHandlers.Remove(value);
    }

    // For a process that may have only a few threads: the C library counts the threads that a connection needs.
    internal bool StartsOnPool { get; init; }

    // Whether consumers are getting a packet now. The statistics count a packet before its first consumer gets it.
    internal bool IsDelivering => _pipeline.IsDelivering;

    // In a handler of frames or replies, and in other code of the application on the receive thread: the managed number of the thread.
    internal int HandlerThreadNumber => _pipeline.HandlerThreadNumber;

    // Frames use discovered values from the moment of discovery. The next status reports them.
    internal FrameFormat Format => _format;

    /// <summary>Name of this reader in metrics and logs: <see cref="NeuronReaderOptions.Name"/>, or else the server's address, UDP port or source.</summary>
    public string Name => _metrics.Name;

    /// <summary>State of the connection, with the reason for its last change.</summary>
    public ConnectionStatus Status => _combinedStatus?.Current ?? _status.Current;

    /// <summary>
    /// State of the connection to <see cref="NeuronReaderOptions.CalculationPort"/>; null if the reader has no such connection. <see cref="Status"/>
    /// describes it in words, and <see cref="StatusChanged"/> reports its changes.
    /// </summary>
    public ConnectionStatus? CalculationStatus => _calculation?.Status;

    /// <summary>
    /// Completes when the reader has stopped for good: after it is disposed, or at the end of its connection if reconnecting is off. It never faults;
    /// <see cref="Status"/> holds the reason.
    /// </summary>
    public Task Completion => _completion.Task;

    /// <summary>
    /// Commands that travel on the reader's own TCP connection. Servers around versions b11 and b12 accept them. They are not available over UDP, nor from a
    /// stream or source.
    /// </summary>
    public DataCommands DataCommands => _pipeline.Commands;

    /// <summary>Gets what the reader has received so far. You can also call it after the end.</summary>
    /// <returns>A snapshot.</returns>
    public ReaderStatistics GetStatistics() => _pipeline.GetStatistics() with { RejectedMessages = _options.Source?.RejectedMessages ?? 0 };

    /// <summary>
    /// Gets what the reader has received so far of each avatar, in order of appearance. A new avatar may take the place of one that got no frame for 5 s, if
    /// there are 1,024: see <see cref="AvatarStatistics"/>. You can also call it after the end.
    /// </summary>
    /// <returns>A snapshot.</returns>
    public IReadOnlyList<AvatarStatistics> GetAvatarStatistics() => _pipeline.GetAvatarStatistics();

    /// <summary>Gets the sizes of an avatar's body from the server's command channel. A stream without displacement does not carry them.</summary>
    /// <remarks>
    /// The first call makes the reader ask in the background. The reader asks again on every new connection, and after a failure. Thread-safe. The method
    /// returns at once, and allocates nothing once the avatar is known.
    /// </remarks>
    /// <param name="avatarIndex">Index of the avatar, from 0, as in its frames.</param>
    /// <param name="body">The body, in centimetres, with the skeleton variant that the server uses.</param>
    /// <returns>
    /// False if the server has not answered for this avatar yet, or if <see cref="NeuronReaderOptions.CommandPort"/> is null.
    /// </returns>
    public bool TryGetBody(int avatarIndex, [NotNullWhen(true)] out SkeletonBody? body) => (body = _discovery?.FindBody(avatarIndex)) is not null;

    private Link CreateLink() => _options.Source is { } source ? new SourceLink(source, _options.Target, _options.Link) : CreateLink(_options.Link, _senders);

    private Link CreateLink(LinkOptions link, SenderFilter senders) =>
        _options.Transport == TransportKind.Tcp ? new TcpLink(link) : new UdpLink(link, senders, _servers, _receiveLock);

    private CalculationConnection CreateCalculationConnection(LinkOptions link, CombinedStatus status) => new(
        _options, _format, _pipeline, _options.Transport == TransportKind.Udp ? _calculationSenders : null, () => CreateLink(link, _calculationSenders), status.OnCalculation);

    private void OnCallbackFailed(Exception exception)
    {
        _reporter.OnFailure(exception);
        _pipeline.CountCallbackFailure();
        try
        {
            if (CallbackFailed is { } handlers)
                handlers(exception);
            else if (_eventHandlers.IsEmpty && Interlocked.Exchange(ref _failureTraced, 1) == 0)
                Trace.TraceError($"A handler of the NeuronReader '{Name}' threw an exception. Later exceptions are only counted; handle CallbackFailed to see them. {exception}");
        }
        catch (Exception)
        {
            _pipeline.CountCallbackFailure();
        }
    }
}
