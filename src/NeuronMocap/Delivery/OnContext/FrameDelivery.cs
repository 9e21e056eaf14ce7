using NeuronMocap.Delivery;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>
/// Delivers frames and changes of status to handlers on a window's thread, through its <see cref="SynchronizationContext"/>. Opened by
/// <see cref="NeuronReader.OpenDelivery"/>.
/// </summary>
/// <remarks>
/// <para>
/// Handlers run on the context and nowhere else, one at a time. At most one post is outstanding, however many frames arrive. A run delivers what waits, for
/// about 4 ms. It then leaves the thread to the other messages of the window before the next run.
/// </para>
/// <para>
/// The receive thread does not wait for the window, unless <see cref="WhenFull.Wait"/> is chosen. While the window is busy, frames wait: see
/// <see cref="FrameDeliveryMode"/>. Delivering a frame allocates nothing, but some contexts allocate for each post.
/// </para>
/// <para>
/// An exception of a handler goes to the context, and thus to the application's own handler, such as <c>Application.ThreadException</c> or
/// <c>Dispatcher.UnhandledException</c>. Other handlers do not get that frame. The delivery continues with the next frame. If a handler runs a nested
/// message loop, for example with a modal dialog, nothing is delivered until the handler returns.
/// </para>
/// <para>
/// A delivery ends when it or its reader is disposed, when the reader stops for good, or when the context is gone. <see cref="Completion"/> holds the reason.
/// It detects that the context is gone if the context rejects a post, or if posts wait and the thread of the context has ended.
/// </para>
/// </remarks>
public sealed class FrameDelivery : IPacketConsumer, IContextWork, IDisposable
{
    private readonly HandlerSet<MotionFrame> _motionHandlers = new();
    private readonly HandlerSet<CalculationFrame> _calculationHandlers = new();
    private readonly HandlerSet<StudioCalculationFrame> _studioHandlers = new();
    private readonly HandlerSet<ConnectionStatus> _statusHandlers = new();
    private readonly StatusBacklog _statuses = new();
    private readonly TaskCompletionSource<FrameDeliveryEnd> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly DeliveryClock _clock;
    private readonly IDeliverySource _source;
    private readonly Action<FrameDelivery> _closed;
    private readonly ContextRunner _runner;
    private readonly HandlerThread _thread;
    private volatile bool _isComplete;
    private volatile bool _hasLast;
    private volatile FrameDeliveryEnd? _end;

    // thread: marked while the receive thread calls Post.
    internal FrameDelivery(FrameDeliveryOptions options, IDeliverySource source, DeliveryClock clock, HandlerThread thread, Action<FrameDelivery> closed)
    {
        _thread = thread;
        _source = source;
        _clock = clock;
        _closed = closed;
        _runner = new ContextRunner(options.Context, options.Post, clock, this);
    }

    /// <summary>Occurs on the context for motion frames. The frame is valid during the call.</summary>
    public event Action<MotionFrame>? MotionReceived
    {
        add => _motionHandlers.Add(value);
        remove => _motionHandlers.Remove(value);
    }

    /// <summary>Occurs on the context for calculation frames. The frame is valid during the call.</summary>
    public event Action<CalculationFrame>? CalculationReceived
    {
        add => _calculationHandlers.Add(value);
        remove => _calculationHandlers.Remove(value);
    }

    /// <summary>Occurs on the context for calculation frames of Axis Studio. The frame is valid during the call.</summary>
    public event Action<StudioCalculationFrame>? StudioCalculationReceived
    {
        add => _studioHandlers.Add(value);
        remove => _studioHandlers.Remove(value);
    }

    /// <summary>
    /// Occurs on the context when the state of the connection changes, in order. If the context is busy for long, only the newest 64 changes are kept.
    /// </summary>
    /// <remarks>
    /// A delivery gets the changes that follow its opening; <see cref="NeuronReader.Status"/> has the state until then.
    /// A change is delivered before frames that wait; only <see cref="ConnectionState.Stopped"/> follows the last frame. When the reader is disposed, the
    /// delivery ends at once and does not deliver that change.
    /// </remarks>
    public event Action<ConnectionStatus>? StatusChanged
    {
        add => _statusHandlers.Add(value);
        remove => _statusHandlers.Remove(value);
    }

    /// <summary>
    /// Completes when the delivery has ended; it never faults. The result tells why. In a handler of the window, <c>await</c> it to continue on the
    /// window's thread.
    /// </summary>
    public Task<FrameDeliveryEnd> Completion => _completion.Task;

    /// <summary>Why the delivery has ended; null while it runs. Thread-safe.</summary>
    public FrameDeliveryEnd? End => _end;

    /// <summary>
    /// Number of frames that were delivered, including frames without a handler. Together with <see cref="Dropped"/>, <see cref="Skipped"/>,
    /// <see cref="Replaced"/> and <see cref="Pending"/>, it equals the number of frames that arrived while the delivery was open. Thread-safe.
    /// </summary>
    public long Delivered => _source.Delivered;

    /// <summary>
    /// Number of frames that were dropped because the queue was full. With <see cref="FrameDeliveryMode.Newest"/>, frames of avatar numbers from
    /// <see cref="LatestFrames.MaxAvatars"/> on. Thread-safe.
    /// </summary>
    public long Dropped => _source.Dropped;

    /// <summary>
    /// With <see cref="FrameDeliveryMode.EveryFrame"/>, number of frames that were left out because of <see cref="FrameDeliveryOptions.MaxRate"/> or
    /// <see cref="FrameDeliveryOptions.EveryNth"/>. Thread-safe.
    /// </summary>
    public long Skipped => _source.Skipped;

    /// <summary>
    /// With <see cref="FrameDeliveryMode.Newest"/>, number of frames that a newer frame replaced before they were delivered. Thread-safe.
    /// </summary>
    public long Replaced => _source.Replaced;

    /// <summary>Number of frames that wait; after the end, that were discarded. Thread-safe.</summary>
    public int Pending => _source.Pending;

    // For a receive thread that waits for room in the queue.
    internal bool MayRun => _end is null && !_runner.HasThreadEnded;

    // The last change follows the last frame.
    private bool HasStatus => !_statuses.IsEmpty && !(_isComplete && _source.Pending > 0);

    /// <summary>Ends the delivery and discards what waits. Any thread, any number of times; never waits for a handler.</summary>
    /// <remarks>
    /// When this method is called on the context's thread, also in a handler, no handler is called afterwards. When it is called on another thread, a
    /// handler that is being called at that moment finishes, and no other follows.
    /// </remarks>
    public void Dispose() => Finish(new FrameDeliveryEnd(FrameDeliveryEndReason.Disposed, "The delivery was disposed."));

    // Any thread of the reader.
    internal void OnStatus(ConnectionStatus status)
    {
        if (_end is not null)
            return;

        // In this order: a run in between must not deliver the last change before frames that wait.
        if (status.State == ConnectionState.Stopped)
            _isComplete = true;

        _statuses.Add(status);
        _runner.Request(isUrgent: true);
    }

    internal void OnReaderStopped() => Finish(new FrameDeliveryEnd(FrameDeliveryEndReason.ReaderStopped, "The reader has stopped."));

    // On the context, during Work.
    internal void Invoke(AvatarFrame frame)
    {
        switch (frame)
        {
            case MotionFrame motion:
                InvokeAll(_motionHandlers, motion);
                break;
            case CalculationFrame calculation:
                InvokeAll(_calculationHandlers, calculation);
                break;
            case StudioCalculationFrame studio:
                InvokeAll(_studioHandlers, studio);
                break;
        }
    }

    void IPacketConsumer.OnPacket(in ReceivedPacket packet)
    {
        if (_end is not null)
            return;

        if (!_source.Add(packet))
            return;

        _thread.Enter();
        _runner.Request();
        _thread.Leave();
    }

    void IContextWork.Work(long limit)
    {
        while (_end is null && HasStatus && _statuses.TryTake(out ConnectionStatus status))
        {
            _hasLast |= status.State == ConnectionState.Stopped;
            InvokeAll(_statusHandlers, status);
            if (_clock.Now >= limit)
                return;
        }

        long now = _clock.Now;
        while (_end is null && _source.TryDeliver(this, now))
        {
            now = _clock.Now;
            if (now >= limit)
                return;
        }

        if (_hasLast)
            OnReaderStopped();
    }

    bool IContextWork.TryGetDue(out long due)
    {
        bool hasFrames = _source.TryGetDue(out due);
        if (_end is not null)
            return false;

        bool isUrgent = HasStatus || _hasLast;
        if (isUrgent)
            due = 0;

        return hasFrames || isUrgent;
    }

    void IContextWork.OnLost(FrameDeliveryEnd end) => Finish(end);

    private void InvokeAll<T>(HandlerSet<T> handlers, T argument)
    {
        foreach (Action<T> handler in handlers.All)
        {
            if (_end is not null)
                return;

            handler(argument);
        }
    }

    private void Finish(FrameDeliveryEnd end)
    {
        if (Interlocked.CompareExchange(ref _end, end, comparand: null) is not null)
            return;

        _runner.Dispose();
        _closed(this);
        _source.Dispose();
        _completion.TrySetResult(end);
    }
}
