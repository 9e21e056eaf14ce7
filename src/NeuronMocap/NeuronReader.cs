using System.Diagnostics;
using NeuronMocap.Commands;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Playback;
using NeuronMocap.Protocol;
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
/// One reader has one connection, or one UDP port; a program may have any number of readers. All members may be called from any thread.
/// </para>
/// </summary>
public sealed partial class NeuronReader : IDisposable, IAsyncDisposable
{
    // Longest wait for a handler that is running while the reader is disposed of.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(2);

    private readonly NeuronReaderOptions _options;
    private readonly CancellationTokenSource _stop = new();
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly TaskCompletionSource<bool> _stopped = new();
    private readonly TaskCompletionSource<bool> _connected = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly FrameFormat _format;
    private readonly ReaderMetrics _metrics;
    private readonly ReceivePipeline _pipeline;
    private readonly HandlerList<ReaderEvent> _eventHandlers;
    private readonly EventReporter _reporter;
    private readonly HandlerList<ConnectionStatus> _statusHandlers;
    private readonly StatusBoard _status;
    private readonly LinkActivity _activity;
    private readonly SenderFilter _senders;
    private readonly ConnectionSupervisor _supervisor;
    private readonly FormatDiscovery? _discovery;
    private readonly ReaderRecordings _recordings;
    private readonly bool _isPlayback;
    private Timer? _watchdog;
    private int _started;
    private int _begun;
    private int _disposed;
    private int _tellingThread;

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
        _status = new StatusBoard(OnStatusChanged);
        _senders = new SenderFilter(_options.AllowedSenders);
        player?.Attach(_senders, OnCallbackFailed);
        _format = player?.CreateFormat(_options.RotationOrder, _options.SkeletonVariant) ?? _options.Format;
        _discovery = _options.Commands is { } commands ? new FormatDiscovery(commands, _format, OnFormatLearnt) : null;
        var recognizer = new StreamRecognizer(_format);
        _activity = new LinkActivity(
            _status, _options.SilenceTimeout, _options.Transport == TransportKind.Udp ? _senders : null, recognizer.Describe, player is null ? null : () => player.IsPaused);
        _eventHandlers = new HandlerList<ReaderEvent>(OnCallbackFailed);
        _eventHandlers.Add(_options.CreateLog());
        _metrics = new ReaderMetrics(_options.DisplayName);
        _supervisor = new ConnectionSupervisor(createLink ?? player?.LinkFactory ?? CreateLink, _options.Reconnect, _status, _activity, new Random().NextDouble);
        _recordings = new ReaderRecordings(_options, _metrics.Name) { IsObserved = () => !_eventHandlers.IsEmpty };
        _pipeline = new ReceivePipeline(
            _format, recognizer, _activity, _status, _senders, _metrics, _supervisor.TrySend, _recordings, OnCallbackFailed, player?.PatienceSource);
        _reporter = new EventReporter(_metrics.Name, _pipeline, _eventHandlers.Invoke);
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
    /// </summary>
    public event Action<Exception>? CallbackFailed;

    /// <summary>
    /// Called with what deserves a line in a log: every change of the connection's state, on the thread that tells it, and lost and dropped
    /// frames, skipped bytes and failed handlers: the first of each kind within half a second, what follows in one event every 10 s, on a pool thread,
    /// as are the beginning, the losses and the end of recordings.
    /// Both threads may call at the same time; each for itself calls once at a time. On .NET the same goes to <c>NeuronReaderOptions.LoggerFactory</c>.
    /// </summary>
    public event Action<ReaderEvent>? EventReported
    {
        add => _eventHandlers.Add(value);
        remove => _eventHandlers.Remove(value);
    }

    // What discovery tells it is used for the frames from then on, and told with the status.
    internal FrameFormat Format => _format;

    /// <summary>What metrics and logs call this reader: <see cref="NeuronReaderOptions.Name"/>, or the server's address or the UDP port.</summary>
    public string Name => _metrics.Name;

    /// <summary>State of the connection, with the reason of its last change.</summary>
    public ConnectionStatus Status => _status.Current;

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

    /// <summary>Starts connecting and receiving, and returns at once. Starting again does nothing.</summary>
    /// <exception cref="ObjectDisposedException">The reader was disposed of.</exception>
    public void Start()
    {
        ObjectDisposedException.ThrowIf(Volatile.Read(ref _disposed) != 0, this);
        if (Interlocked.Exchange(ref _started, 1) != 0)
            return;

        TimeSpan period = TimeSpan.FromSeconds(Math.Min(0.5, _options.SilenceTimeout.TotalSeconds / 4));
        _watchdog = new Timer(_ => Check(Stopwatch.GetTimestamp()), state: null, period, period);
        _ = Task.Run(RunAsync);
    }

    /// <summary>Starts the reader and waits for its first connection; for UDP, for the port.</summary>
    /// <param name="cancellationToken">Ends the wait; the reader goes on trying.</param>
    /// <returns>A task that completes when the connection stands.</returns>
    /// <exception cref="NeuronConnectionException">Reconnecting is off and there is no connection, or the reader was disposed of meanwhile.</exception>
    /// <exception cref="ObjectDisposedException">The reader was disposed of before.</exception>
    public async Task StartAsync(CancellationToken cancellationToken = default)
    {
        Start();
        var cancelled = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        using (cancellationToken.Register(() => cancelled.TrySetCanceled(cancellationToken)))
            await (await Task.WhenAny(_connected.Task, cancelled.Task).ConfigureAwait(false)).ConfigureAwait(false);
    }

    /// <summary>
    /// Stops receiving and closes the connection, in whatever state it is. When it returns, no handler runs and none will, with two
    /// exceptions: called from a handler it returns before that handler does, and a handler that is still busy after 2 s is left behind.
    /// Any thread, any number of times. Queues and statistics stay readable.
    /// </summary>
    public void Dispose()
    {
        // Not for both in one task, nor for Completion: that would take a thread of the pool, and in a busy process there may be none for a while.
        Stop();
        if (!IsHandlerThread)
            Task.WaitAll([_stopped.Task, _reporter.Over], StopTimeout);
    }

    /// <summary>As <see cref="Dispose"/>, without blocking the thread.</summary>
    /// <returns>A task that completes when the reader has stopped, or after 2 s.</returns>
    public async ValueTask DisposeAsync()
    {
        Stop();
        if (IsHandlerThread)
            return;

        // What follows is the caller's, and not for a thread of the reader.
        Task stopped = Task.WhenAll(_stopped.Task, _reporter.Over).ContinueWith(
            static _ => { }, CancellationToken.None, TaskContinuationOptions.RunContinuationsAsynchronously, TaskScheduler.Default);
        await Task.WhenAny(stopped, Task.Delay(StopTimeout)).ConfigureAwait(false);
    }

    // Only the thread itself can find its own number here, so no barrier is needed.
    private bool IsHandlerThread
    {
        get
        {
            int thread = Environment.CurrentManagedThreadId;
            return thread == _tellingThread || thread == _pipeline.DeliveringThread || _reporter.IsReporting;
        }
    }

    private void Stop()
    {
        if (Interlocked.Exchange(ref _disposed, 1) == 0)
        {
            _pipeline.Stop();
            _metrics.Dispose();
            _watchdog?.Dispose();
            _discovery?.Dispose();
            if (Interlocked.Exchange(ref _started, 1) == 0)
                End();
            else
                _ = DedicatedThread.RunAsync("NeuronMocap stop", End);
        }
    }

    // What waits goes on in here as far as it can, down to the handlers of the last status, so that no end needs a pool thread: in a busy process
    // there may be none for a while. On a thread of its own, because those handlers may take longer than a stop.
    private void End()
    {
        _stop.Cancel();
        if (Interlocked.Exchange(ref _begun, 1) == 0)
            _ = EndAsync(new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.Requested, LinkEnd.Requested.Message));
    }

    private async Task RunAsync()
    {
        // Stopped before a pool thread had time for the start.
        if (Interlocked.Exchange(ref _begun, 1) != 0)
        {
            _watchdog?.Dispose();
            return;
        }

        ConnectionStatus last;
        try
        {
            last = await _supervisor.RunAsync(_pipeline, _stop.Token).ConfigureAwait(false);
        }
        catch (Exception exception)
        {
            // Nothing the network does comes here; whoever waits for the end shall not wait for ever because of a fault of ours.
            last = new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.NetworkError, $"The reader failed: {exception}");
        }

        await EndAsync(last).ConfigureAwait(false);
    }

    // The last report, then the last status, whatever becomes of the report.
    private async Task EndAsync(ConnectionStatus last)
    {
        try
        {
            _watchdog?.Dispose();
            _discovery?.Dispose();
            await _recordings.StopAsync().ConfigureAwait(false);
            await _reporter.EndAsync(Stopwatch.GetTimestamp()).ConfigureAwait(false);
        }
        finally
        {
            _status.Set(last);
        }
    }

    private void Check(long now)
    {
        _activity.Check(now);
        if (_status.Current.IsConnected)
            _discovery?.Check(now);
        if (!_eventHandlers.IsEmpty)
            _reporter.Check(now);
    }

    // When the handlers of Stopped, the last status, have run.
    private void Complete(ConnectionStatus last)
    {
        _connected.TrySetException(new NeuronConnectionException(last.Reason, last.Message));
        _ = _connected.Task.Exception; // observed: most programs never wait for the connection
        _pipeline.End();
        _completion.TrySetResult(true);
        _stopped.TrySetResult(true);
    }

    private Link CreateLink() => _options.Transport == TransportKind.Tcp ? new TcpLink(_options.Link) : new UdpLink(_options.Link, _senders);

    private void OnStatusChanged(ConnectionStatus status)
    {
        if (status.IsConnected)
            _connected.TrySetResult(true);
        if (status.State == ConnectionState.Connected)
        {
            _discovery?.Begin();
            _recordings.Ask();
        }

        _recordings.Learn(status.Format);
        _tellingThread = Environment.CurrentManagedThreadId;
        _reporter.OnStatus(status);
        _statusHandlers.Invoke(status);
        _tellingThread = 0;
        if (status.State == ConnectionState.Stopped)
            Complete(status);
    }

    private void OnFormatLearnt()
    {
        _activity.Redescribe(Stopwatch.GetTimestamp(), isDue: true);
        _recordings.Learn(_format.Findings.Order, _format.Findings.Variant);
    }

    private void OnCallbackFailed(Exception exception)
    {
        _reporter.OnFailure(exception);
        _pipeline.CountCallbackFailure();
        try
        {
            CallbackFailed?.Invoke(exception);
        }
        catch (Exception)
        {
            _pipeline.CountCallbackFailure();
        }
    }
}
