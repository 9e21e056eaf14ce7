using System.Runtime.CompilerServices;
using NeuronMocap.Commands;
using NeuronMocap.Delivery;
using NeuronMocap.Files;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Telemetry;
using NeuronMocap.Transport;

namespace NeuronMocap.Reader;

// What happens to a packet between the receive thread and the consumers, and who the consumers are.
internal sealed class ReceivePipeline : IPacketReceiver, IReaderFigures
{
    private const string StreamName = "stream";

    private readonly FrameFormat _format;
    private readonly StreamRecognizer _recognizer;
    private readonly LinkActivity _activity;
    private readonly StatusBoard _status;
    private readonly SenderFilter _senders;
    private readonly ReaderMetrics _metrics;
    private readonly ReaderRecordings _recordings;
    private readonly Func<bool>? _isPatient;

    // Of a reader with two connections, whose threads take turns from here on: everything behind has one producer. Null for one connection.
    private readonly object? _gate;
    private readonly StreamCounters _counters;
    private readonly PacketDispatcher _dispatcher;
    private readonly object _lock = new();
    private readonly List<FrameQueue> _queues = [];
    private readonly List<FrameStream> _streams = [];
    private readonly Dictionary<string, long> _droppedByClosedQueues = new(StringComparer.Ordinal);
    private long _callbackFailures;
    private long _undelivered;
    private bool _ended;
    private volatile bool _stopped;

    public ReceivePipeline(
        FrameFormat format,
        StreamRecognizer recognizer,
        LinkActivity activity,
        StatusBoard status,
        SenderFilter senders,
        ReaderMetrics metrics,
        DataCommands.TrySend trySend,
        ReaderRecordings recordings,
        Action<Exception> callbackFailed,
        Func<bool>? isPatient = null,
        object? gate = null)
    {
        _gate = gate;
        _recordings = recordings;
        _format = format;
        _recognizer = recognizer;
        _activity = activity;
        _status = status;
        _senders = senders;
        _metrics = metrics;
        _isPatient = isPatient is null ? null : () => !_stopped && isPatient();
        _counters = new StreamCounters(metrics.Intervals);
        _dispatcher = new PacketDispatcher(_counters);
        Callbacks = new FrameCallbacks(format, callbackFailed);
        Commands = new DataCommands(trySend, callbackFailed);
        _dispatcher.Add(Callbacks);
        metrics.Observe(this);
    }

    public ConnectionState State => _status.State;

    public long UnsettledLoss => _counters.Trackers.Sum(static tracker => tracker.Index.Unsettled);

    public StreamTap? Tap => _recordings.Tap;

    public IReadOnlyList<IFileOutput> Outputs => _recordings.All;

    public FrameCallbacks Callbacks { get; }

    public DataCommands Commands { get; }

    // The thread that is handing out a packet, or 0. Meant to be compared with the calling thread only.
    public int DeliveringThread { get; private set; }

    public void OnPacket(in ReceivedPacket packet)
    {
        if (_stopped)
        {
            CountUndelivered(packet);
            return;
        }

        if (_gate is null)
            DeliveringThread = Environment.CurrentManagedThreadId;

        bool isNews = packet.IsFrame && _recognizer.OnFrame(packet);
        _activity.BeginDelivery(packet);
        try
        {
            if (isNews)
                _activity.Redescribe(packet.Timestamp);

            if (_gate is null)
                Dispatch(packet);
            else
                DeliverInTurn(packet);
        }
        finally
        {
            _activity.EndDelivery();
            if (_gate is null)
                DeliveringThread = 0;
        }
    }

    // Of either of two connections.
    public void DeliverInTurn(in ReceivedPacket packet)
    {
        lock (_gate!)
        {
            if (_stopped)
            {
                CountUndelivered(packet);
                return;
            }

            DeliveringThread = Environment.CurrentManagedThreadId;
            try
            {
                Dispatch(packet);
            }
            finally
            {
                DeliveringThread = 0;
            }
        }
    }

    public void OnText(ReadOnlySpan<byte> bytes) => CountText(bytes.Length);

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        if (_stopped)
            return;

        CountSkipped(bytes.Length, reason);
        _activity.OnSkipped(bytes, reason);
    }

    // Of either connection.
    public void CountText(int bytes)
    {
        if (_stopped)
            return;

        if (_gate is null)
        {
            _counters.CountText(bytes);
            return;
        }

        lock (_gate)
            _counters.CountText(bytes);
    }

    // Of either connection.
    public void CountSkipped(int bytes, SkipReason reason)
    {
        if (_gate is null)
        {
            _counters.CountSkipped(bytes, reason);
            return;
        }

        lock (_gate)
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

    // From here on nothing is delivered, even where the receive thread still holds bytes; frames are counted.
    public void Stop() => _stopped = true;

    // No more packets will come.
    public void End()
    {
        lock (_lock)
        {
            _ended = true;
            foreach (FrameStream stream in _streams)
                stream.End();
        }
    }

    public FrameQueue OpenQueue(int capacity, string name)
    {
        var queue = new FrameQueue(capacity, _format, closed => Close(closed, closed), name, _metrics.HandOver(name), _isPatient);
        Open(queue, queue);
        return queue;
    }

    public FrameQueue OpenMotionQueue(int capacity, string name, out MotionOnlyConsumer intake)
    {
        MotionOnlyConsumer? consumer = null;
        var queue = new FrameQueue(capacity, _format, closed => Close(closed, consumer!), name, _metrics.HandOver(name));
        intake = consumer = new MotionOnlyConsumer(queue);
        Open(queue, consumer);
        return queue;
    }

    public LatestFrames OpenLatest()
    {
        var latest = new LatestFrames(_format, _dispatcher.Remove, _metrics.HandOver("latest"));
        _dispatcher.Add(latest);
        return latest;
    }

    public FrameStream OpenStream(PacketKind kind, out FrameQueue queue)
    {
        FrameStream? stream = null;
        queue = new FrameQueue(
            FrameQueue.DefaultCapacity, _format, closed => Close(closed, stream!), StreamName, _metrics.HandOver(StreamName), _isPatient);
        stream = new FrameStream(queue, kind);
        Open(queue, stream);
        return stream;
    }

    public ReaderStatistics GetStatistics()
    {
        lock (_lock)
        {
            long dropped = 0;
            foreach (long closed in _droppedByClosedQueues.Values)
                dropped += closed;
            foreach (FrameQueue queue in _queues)
                dropped += queue.Dropped;

            return _counters.Snapshot() with
            {
                Dropped = dropped,
                RefusedDatagrams = _senders.RefusedDatagrams,
                Undelivered = Interlocked.Read(ref _undelivered),
                CallbackFailures = Volatile.Read(ref _callbackFailures),
            };
        }
    }

    public IReadOnlyList<AvatarStatistics> GetAvatarStatistics() => [.. _counters.Trackers.Select(static tracker => tracker.Snapshot)];

    public IReadOnlyList<ConsumerStatistics> GetConsumers()
    {
        lock (_lock)
        {
            ILookup<string, FrameQueue> open = _queues.ToLookup(static queue => queue.Name, StringComparer.Ordinal);
            return
            [
                .. _droppedByClosedQueues.Keys.Union(open.Select(static group => group.Key), StringComparer.Ordinal)
                    .Select(name => new ConsumerStatistics(
                        name,
                        _droppedByClosedQueues.GetValueOrDefault(name) + open[name].Sum(static queue => queue.Dropped),
                        open[name].Sum(static queue => queue.Count))),
            ];
        }
    }

    public void Forget(IFileOutput output) => _recordings.Forget(output);

    public long GetSkipped(SkipReason reason) => _counters.GetSkipped(reason);

    public void CountCallbackFailure() => Interlocked.Increment(ref _callbackFailures);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Dispatch(in ReceivedPacket packet)
    {
        _dispatcher.Dispatch(packet);
        if (packet.Kind == PacketKind.Command)
            Commands.OnPacket(packet);
    }

    // Of either connection, without turns.
    private void CountUndelivered(in ReceivedPacket packet)
    {
        if (packet.IsFrame)
            Interlocked.Increment(ref _undelivered);
    }

    // Nobody else counts while a connection is opened, but a second one does.
    private void Resume(bool isCalculation)
    {
        lock (_gate ?? _lock)
            _counters.Resume(isCalculation);
    }

    private void Open(FrameQueue queue, IPacketConsumer consumer)
    {
        lock (_lock)
        {
            _queues.Add(queue);
            if (consumer is FrameStream stream)
            {
                _streams.Add(stream);
                if (_ended)
                    stream.End();
            }
        }

        _dispatcher.Add(consumer);
    }

    private void Close(FrameQueue queue, IPacketConsumer consumer)
    {
        _dispatcher.Remove(consumer);
        lock (_lock)
        {
            if (_queues.Remove(queue))
                _droppedByClosedQueues[queue.Name] = _droppedByClosedQueues.GetValueOrDefault(queue.Name) + queue.Dropped;
            if (consumer is FrameStream stream)
                _streams.Remove(stream);
        }
    }
}
