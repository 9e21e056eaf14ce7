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

/// <summary>
/// Receives the motion capture stream of Axis Neuron, Axis Studio or a simulator, and hands its frames to the application.
/// <para>
/// Make one, choose how frames shall arrive, start it, dispose of it at the end:
/// <see cref="OpenQueue"/> gives every frame to a thread of yours when you ask for them (a main loop);
/// <see cref="OpenLatest"/> gives the newest frame of each avatar (a renderer);
/// <see cref="MotionReceived"/>, <see cref="CalculationReceived"/> and <see cref="StudioCalculationReceived"/> call you on the receive thread (the
/// shortest way); <see cref="ReadMotionAsync"/> and its like are for code that awaits.
/// They can be mixed, and opened and closed while the reader runs. All but the last allocate nothing per frame.
/// </para>
/// <para>
/// One reader has one connection, or one UDP port, and a second one where <see cref="NeuronReaderOptions.CalculationPort"/> says so; a program may have any number of readers. All members may be called from any thread.
/// </para>
/// <para>
/// A reader that runs stays alive, with its connection and its handlers, also when nothing in the program refers to it: as a thread does. It ends when it
/// is disposed of or, where reconnecting is off, with its connection. A reader that was never started, or has ended, is collected like any object.
/// </para>
/// </summary>
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
    private readonly ConnectionSupervisor _supervisor;
    private readonly UdpServers? _servers;
    private readonly object? _receiveLock;
    private readonly CombinedStatus? _combinedStatus;
    private readonly CalculationConnection? _calculation;
    private readonly ServerDiscovery? _discovery;
    private readonly ReaderRecordings _recordings;
    private readonly bool _isPlayback;
    private Timer? _watchdog;
    private int _started;
    private int _begun;
    private int _disposed;
    private int _reportingThread;
    private int _failureTraced;

    /// <summary>Makes a reader for a TCP server.</summary>
    /// <param name="host">Name or address of the computer that runs Axis Neuron.</param>
    /// <param name="port">The server's port, 1 to 65535.</param>
    /// <exception cref="ArgumentException">The host is empty or the port out of range.</exception>
    public NeuronReader(string host, int port = ProtocolConstants.DefaultPort)
        : this(new NeuronReaderOptions { Host = host, Port = port })
    {
    }

    /// <summary>Makes a reader.</summary>
    /// <param name="options">Where to receive from, and how; copied.</param>
    /// <exception cref="ArgumentException">An option is out of its range; the message names it.</exception>
    public NeuronReader(NeuronReaderOptions options)
        : this(options, createLink: null)
    {
    }

    /// <summary>Makes a reader for what a file holds of a stream, instead of a live one.</summary>
    /// <param name="player">Plays the file, once the reader is started; it can have one reader, which does not dispose of it.</param>
    /// <param name="options">
    /// How to receive; copied; null for the defaults. Whatever is about a connection has no meaning here: server, port, senders, reconnecting and command
    /// port; the largest number of values is the player's. The rotation order and the skeleton variant count before the player's.
    /// </param>
    /// <exception cref="ArgumentException">An option is out of its range; the message names it.</exception>
    /// <exception cref="InvalidOperationException">The player has a reader.</exception>
    /// <exception cref="ObjectDisposedException">The player was disposed of.</exception>
    public NeuronReader(RecordingPlayer player, NeuronReaderOptions? options = null)
        : this(options ?? new NeuronReaderOptions(), createLink: null, player ?? throw new ArgumentNullException(nameof(player)))
    {
    }

    internal NeuronReader(NeuronReaderOptions options, Func<Link>? createLink)
        : this(options, createLink, player: null)
    {
    }

    private NeuronReader(NeuronReaderOptions options, Func<Link>? createLink, RecordingPlayer? player)
    {
        ArgumentNullException.ThrowIfNull(options);
        if (options.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        _isPlayback = player is not null;
        _options = player is null ? options.Copy() : options.CopyFor(player);
        _statusHandlers = new HandlerList<ConnectionStatus>(OnCallbackFailed);
        if (_options.CalculationLink is { } second)
        {
            _receiveLock = new object();
            _servers = new UdpServers();
            _combinedStatus = new CombinedStatus(OnStatusChanged, second.Port);
        }

        _status = new StatusPublisher(OnFirstStatusChanged);
        _senders = new SenderFilter(_options.AllowedSenders);
        Func<Link>? playback = player?.Attach(_senders, OnCallbackFailed);
        _format = player?.CreateFormat(_options.RotationOrder, _options.SkeletonVariant) ?? _options.Format;
        _discovery = _options.Commands is { } commands ? new ServerDiscovery(commands, _format, OnFormatLearnt) : null;
        var recognizer = new StreamRecognizer(_format);
        _activity = new LinkActivity(
            _status, _options.SilenceTimeout, _options.Transport == TransportKind.Udp ? _senders : null, recognizer.Describe, player is null ? null : () => player.IsPaused);
        _eventHandlers = new HandlerList<ReaderEvent>(OnCallbackFailed);
        _eventHandlers.Add(_options.CreateLog());
        _metrics = new ReaderMetrics(_options.DisplayName);
        _supervisor = new ConnectionSupervisor(createLink ?? playback ?? CreateLink, _options.Reconnect, _status, _activity, new Random().NextDouble);
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
            _format, recognizer, _activity, _status, _senders, _metrics, _supervisor.TrySend, _recordings, OnCallbackFailed, player?.BackPressure, _receiveLock);
        if (_combinedStatus is not null)
            _calculation = CreateCalculationConnection(_options.CalculationLink!, _combinedStatus);

        _reporter = new EventReporter(_metrics.Name, _pipeline, _eventHandlers.Invoke) { EndTimeout = _options.StopTimeout / 2 };
    }

    /// <summary>
    /// Called with every change of the connection's state, in order and one at a time, on one of the reader's threads or the pool's, or on the thread
    /// that disposes of a reader that never started. A handler may do anything, dispose of the reader included, but should not take long.
    /// </summary>
    public event Action<ConnectionStatus>? StatusChanged
    {
        add => _statusHandlers.Add(value);
        remove => _statusHandlers.Remove(value);
    }

    /// <summary>
    /// Called with every exception that a handler of this reader's events threw, on the thread that called the handler. The exception goes
    /// no further: other handlers and the connection go on. An exception of this event's own handlers is only counted.
    /// <para>
    /// As long as neither this event nor <see cref="EventReported"/> nor a log is in use, the first exception of a reader is written to
    /// <see cref="Trace"/>. <see cref="ReaderStatistics.CallbackFailures"/> counts all of them in any case.
    /// </para>
    /// </summary>
    public event Action<Exception>? CallbackFailed;

    /// <summary>
    /// Called with what deserves a line in a log: every change of the connection's state, on the thread that tells it, and lost and dropped
    /// frames, skipped bytes and failed handlers: the first of each kind within half a second, what follows in one event every 10 s, on a pool thread,
    /// as are the beginning and the losses of recordings and exports. Their end is told at once, on their own thread.
    /// These threads may call at the same time; each for itself calls once at a time. On .NET the same goes to <c>NeuronReaderOptions.LoggerFactory</c>.
    /// </summary>
    public event Action<ReaderEvent>? EventReported
    {
        add => _eventHandlers.Add(value);
        remove => _eventHandlers.Remove(value);
    }

    // For a process that may have few threads: the C library counts those that a connection needs.
    internal bool StartsOnPool { get; init; }

    // Whether a packet is on its way through the consumers. The statistics count it before the first one gets it.
    internal bool IsDelivering => _pipeline.DeliveringThread != 0;

    // What discovery tells it is used for the frames from then on, and told with the status.
    internal FrameFormat Format => _format;

    /// <summary>What metrics and logs call this reader: <see cref="NeuronReaderOptions.Name"/>, or the server's address or the UDP port.</summary>
    public string Name => _metrics.Name;

    /// <summary>State of the connection, with the reason of its last change.</summary>
    public ConnectionStatus Status => _combinedStatus?.Current ?? _status.Current;

    /// <summary>
    /// State of the connection to <see cref="NeuronReaderOptions.CalculationPort"/>; null where the reader has none. <see cref="Status"/> tells it in words,
    /// and <see cref="StatusChanged"/> that it changed.
    /// </summary>
    public ConnectionStatus? CalculationStatus => _calculation?.Status;

    /// <summary>
    /// Completes when the reader has stopped for good: disposed of, or at the end of its connection where reconnecting is off. Never faults;
    /// <see cref="Status"/> tells the reason.
    /// </summary>
    public Task Completion => _completion.Task;

    /// <summary>
    /// Commands that travel on this reader's own TCP connection, as servers of the time of b11 and b12 take them. Over UDP there are none.
    /// </summary>
    public DataCommands DataCommands => _pipeline.Commands;

    /// <summary>What was received so far. Also after the end.</summary>
    /// <returns>A snapshot.</returns>
    public ReaderStatistics GetStatistics() => _pipeline.GetStatistics();

    /// <summary>What was received so far of each avatar, in the order in which they appeared; at most 1024. Also after the end.</summary>
    /// <returns>A snapshot.</returns>
    public IReadOnlyList<AvatarStatistics> GetAvatarStatistics() => _pipeline.GetAvatarStatistics();

    /// <summary>
    /// Gets the sizes of an avatar's body, as the server's command channel describes them. A stream without displacement does not carry them.
    /// The first call makes the reader ask in the background; it asks again on every new connection, and after a failure. Returns at once, on any
    /// thread, and allocates nothing once the avatar is known.
    /// </summary>
    /// <param name="avatarIndex">Index of the avatar, from 0, as its frames carry it.</param>
    /// <param name="body">The body, of the skeleton variant that the server uses; centimetres.</param>
    /// <returns>
    /// False when the server has not answered for this avatar yet, or <see cref="NeuronReaderOptions.CommandPort"/> is null.
    /// </returns>
    public bool TryGetBody(int avatarIndex, [NotNullWhen(true)] out SkeletonBody? body) => (body = _discovery?.FindBody(avatarIndex)) is not null;

    private Link CreateLink() => CreateLink(_options.Link);

    private Link CreateLink(LinkOptions link) => _options.Transport == TransportKind.Tcp ? new TcpLink(link) : new UdpLink(link, _senders, _servers, _receiveLock);

    private CalculationConnection CreateCalculationConnection(LinkOptions link, CombinedStatus status) => new(
        _options, _format, _pipeline, _options.Transport == TransportKind.Udp ? _senders : null, () => CreateLink(link), status.OnCalculation);

    private void OnCallbackFailed(Exception exception)
    {
        _reporter.OnFailure(exception);
        _pipeline.CountCallbackFailure();
        try
        {
            if (CallbackFailed is { } handlers)
                handlers(exception);
            else if (_eventHandlers.IsEmpty && Interlocked.Exchange(ref _failureTraced, 1) == 0)
                Trace.TraceError($"A handler of the NeuronReader '{Name}' threw an exception. Further ones are only counted; handle CallbackFailed to see them. {exception}");
        }
        catch (Exception)
        {
            _pipeline.CountCallbackFailure();
        }
    }
}
