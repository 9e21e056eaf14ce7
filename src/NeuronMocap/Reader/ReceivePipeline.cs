using System.Runtime.CompilerServices;
using NeuronMocap.Commands;
using NeuronMocap.Delivery;
using NeuronMocap.Files;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Telemetry;
using NeuronMocap.Transport;

namespace NeuronMocap.Reader;

// The path of a packet from the receive thread to the consumers, and the list of consumers.
internal sealed class ReceivePipeline : IPacketReceiver, ILinkListener, IReaderStatistics
{
    private const string StreamName = "stream";

    private static readonly FrameQueueOptions DefaultQueue = new();

    private readonly FrameFormat _format;
    private readonly StreamRecognizer _recognizer;
    private readonly LinkActivity _activity;
    private readonly StatusPublisher _status;
    private readonly SenderFilter[] _senders;
    private readonly ReaderMetrics _metrics;
    private readonly ReaderRecordings _recordings;
    private readonly Func<WhenFull, bool>? _mayWait;

    // For a reader with two connections. Their threads take turns from here on, so all later code has one producer. Null for one connection.
    private readonly object? _receiveLock;
    private readonly StreamCounters _counters;
    private readonly PacketDispatcher _dispatcher;
    private readonly DeliveryList _deliveries = new();
    private readonly HandlerThread _handlerThread = new();
    private readonly object _lock = new();
    private volatile bool _deliversInTurn;
    private volatile bool _stopped;

    public ReceivePipeline(
        FrameFormat format,
        StreamRecognizer recognizer,
        LinkActivity activity,
        StatusPublisher status,
        SenderFilter[] senders,
        ReaderMetrics metrics,
        DataCommands.TrySend trySend,
        ReaderRecordings recordings,
        Action<Exception> callbackFailed,
        Func<WhenFull, bool>? mayWait = null,
        object? receiveLock = null)
    {
        _receiveLock = receiveLock;
        _recordings = recordings;
        _format = format;
        _recognizer = recognizer;
        _activity = activity;
        _status = status;
        _senders = senders;
        _metrics = metrics;
        _mayWait = mayWait;
        _counters = new StreamCounters(metrics.Intervals is { } intervals ? new ReportedIntervals(intervals, _handlerThread) : null);
        _dispatcher = new PacketDispatcher(_counters);
        Callbacks = new FrameCallbacks(format, callbackFailed, _handlerThread);
        Commands = new DataCommands(trySend, callbackFailed);
        _dispatcher.Add(Callbacks);
        metrics.Observe(this);
    }

    public ConnectionState State => _status.State;

    public int? ReceiveBufferSize => _status.Current.ReceiveBufferSize;

    public long UnsettledLoss => _counters.Trackers.Sum(static tracker => tracker.Index.Unsettled);

    public StreamTap Tap => _recordings.Tap;

    public IReadOnlyList<IFileOutput> Outputs => _recordings.All;

    public FrameCallbacks Callbacks { get; }

    public DataCommands Commands { get; }

    // The thread that runs code of the application for a packet, or 0. Other threads may see an old value.
    public int HandlerThreadNumber => _handlerThread.Number;

    // Whether consumers are getting a packet now. Any thread.
    public bool IsDelivering => _activity.IsDelivering || _deliversInTurn;

    public void OnPacket(in ReceivedPacket packet)
    {
        if (_stopped)
        {
            _counters.CountUndelivered();
            return;
        }

        bool isNews = packet.IsFrame && _recognizer.OnFrame(packet);
        _activity.BeginDelivery(packet);
        try
        {
            if (isNews)
                _activity.Redescribe(packet.Timestamp);

            if (_receiveLock is null)
                Dispatch(packet);
            else
                DeliverInTurn(packet);
        }
        finally
        {
            _activity.EndDelivery();
        }
    }

    // For either of two connections.
    public void DeliverInTurn(in ReceivedPacket packet)
    {
        lock (_receiveLock!)
        {
            if (_stopped)
            {
                _counters.CountUndelivered();
                return;
            }

            _deliversInTurn = true;
            try
            {
                Dispatch(packet);
            }
            finally
            {
                _deliversInTurn = false;
            }
        }
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind) => CountText(bytes.Length);

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        if (_stopped)
            return;

        CountSkipped(bytes.Length, reason);
        _activity.OnSkipped(bytes, reason);
    }

    // For either connection.
    public void CountText(int bytes)
    {
        if (_stopped)
            return;

        if (_receiveLock is null)
        {
            _counters.CountText(bytes);
            return;
        }

        lock (_receiveLock)
            _counters.CountText(bytes);
    }

    // For either connection.
    public void CountSkipped(int bytes, SkipReason reason)
    {
        if (_receiveLock is null)
        {
            _counters.CountSkipped(bytes, reason);
            return;
        }

        lock (_receiveLock)
            _counters.CountSkipped(bytes, reason);
    }

    public void OnLinkOpened()
    {
        _recognizer.Reset();
        Resume(isCalculation: false);
        Commands.OnLinkOpened();
    }

    public void OnCalculationLinkOpened() => Resume(isCalculation: true);

    public void OnLinkClosed() => Commands.OnLinkClosed();

    // After this call nothing is delivered, even if the receive thread still has bytes; it only counts the packets. No handler of a delivery begins.
    public void Stop()
    {
        _stopped = true;
        _deliveries.EndAll();
    }

    // Called when no more packets will arrive.
    public void End() => _counters.Consumers.CompleteAdding();

    public FrameQueue OpenQueue(int capacity, string name) => OpenQueue(new FrameQueueOptions { Capacity = capacity, Name = name });

    public FrameQueue OpenQueue(FrameQueueOptions options) =>
        Open(CreateQueue(options.Copy(FrameQueue.DefaultName), PacketKind.None, BackPressureFor(options.WhenFull)));

    public FrameQueue OpenMotionQueue(int capacity, string name) =>
        Open(CreateQueue(new FrameQueueOptions { Capacity = capacity, Name = name }, PacketKind.Motion, backPressure: null));

    // For a consumer that waits for frames. It never slows an unpaced playback down.
    public FrameQueue OpenMotionQueue(FrameQueueOptions options)
    {
        FrameQueue queue = CreateQueue(options.Copy(FrameQueue.DefaultName), PacketKind.Motion, backPressure: null);
        queue.PrepareWaiting();
        return Open(queue);
    }

    public FrameStream OpenStream(PacketKind kind, FrameQueueOptions? options = null)
    {
        FrameQueueOptions how = (options ?? DefaultQueue).Copy(StreamName);
        FrameQueue queue = CreateQueue(how, kind, BackPressureFor(how.WhenFull));
        var stream = new FrameStream(queue);
        Open(queue);
        return stream;
    }

    public LatestFrames OpenLatest() => OpenLatest(FrameThinning.None);

    public LatestFrames OpenLatest(FrameThinning thinning)
    {
        var latest = new LatestFrames(_format, Close, _metrics.HandOver(LatestFrames.MetricName), thinning.CreateThinner());
        if (thinning != FrameThinning.None)
            _counters.Consumers.Add(latest);

        _dispatcher.Add(latest);
        return latest;
    }

    // closed: called when the delivery ends.
    public FrameDelivery OpenDelivery(FrameDeliveryOptions options, DeliveryClock clock, Action<FrameDelivery> closed)
    {
        FrameDelivery? delivery = null;
        FrameQueue? queue = null;
        IDeliverySource source;
        if (options.Mode == FrameDeliveryMode.Newest)
        {
            source = new NewestSource(_format, options.MaxRate, _metrics.HandOver(options.Name));
        }
        else
        {
            Func<bool>? mayWait = BackPressureFor(options.WhenFull);
            queue = new FrameQueue(
                options.Capacity,
                _format,
                _counters.Consumers.Remove,
                options.Name,
                _metrics.HandOver(options.Name),
                mayWait is null ? null : () => mayWait() && delivery!.MayRun,
                options.WhenFull,
                options.Thinning.CreateThinner());
            source = new QueueSource(queue);
        }

        delivery = new FrameDelivery(options, source, clock, _handlerThread, ended =>
        {
            _dispatcher.Remove(ended);
            _deliveries.Remove(ended);
            closed(ended);
        });
        if (queue is not null)
            _counters.Consumers.Add(queue);

        _dispatcher.Add(delivery);
        _deliveries.Add(delivery);
        return delivery;
    }

    public ReaderStatistics GetStatistics()
    {
        long refused = 0;
        foreach (SenderFilter filter in _senders)
            refused += filter.RefusedDatagrams;

        return _counters.Snapshot() with { RefusedDatagrams = refused };
    }

    public IReadOnlyList<AvatarStatistics> GetAvatarStatistics() => [.. _counters.Trackers.Select(static tracker => tracker.Snapshot)];

    public IReadOnlyList<ConsumerStatistics> GetConsumers() => _counters.Consumers.Snapshot();

    public void Forget(IFileOutput output) => _recordings.Forget(output);

    public long GetSkipped(SkipReason reason) => _counters.GetSkipped(reason);

    public void CountCallbackFailure() => _counters.CountCallbackFailure();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Dispatch(in ReceivedPacket packet)
    {
        _dispatcher.Dispatch(packet);
        if (packet.Kind != PacketKind.Command)
            return;

        _handlerThread.Enter();
        Commands.OnPacket(packet);
        _handlerThread.Leave();
    }

    // While a connection is opened, only a second connection can count at the same time.
    private void Resume(bool isCalculation)
    {
        lock (_receiveLock ?? _lock)
            _counters.Resume(isCalculation);
    }

    private FrameQueue CreateQueue(FrameQueueOptions options, PacketKind only, Func<bool>? backPressure) =>
        new(options.Capacity, _format, Close, options.Name!, _metrics.HandOver(options.Name!), backPressure, options.WhenFull, options.Thinning.CreateThinner())
        {
            OnlyKind = only,
        };

    // A stop ends every wait, because the reader may be disposed on the thread that would have made room. So does the end of a playback. Null for no wait.
    private Func<bool>? BackPressureFor(WhenFull whenFull)
    {
        if (_mayWait is { } mayWait)
            return () => !_stopped && mayWait(whenFull);

        return whenFull == WhenFull.Wait ? () => !_stopped : null;
    }

    private FrameQueue Open(FrameQueue queue)
    {
        _counters.Consumers.Add(queue);
        _dispatcher.Add(queue);
        return queue;
    }

    private void Close(FrameQueue queue)
    {
        _dispatcher.Remove(queue);
        _counters.Consumers.Remove(queue);
    }

    private void Close(LatestFrames latest)
    {
        _dispatcher.Remove(latest);
        _counters.Consumers.Remove(latest);
    }
}
