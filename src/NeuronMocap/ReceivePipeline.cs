using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap;

// What happens to a packet between the receive thread and the consumers, and who the consumers are.
internal sealed class ReceivePipeline : IPacketReceiver
{
    private readonly SkeletonFormat _format;
    private readonly LinkActivity _activity;
    private readonly StreamCounters _counters = new();
    private readonly PacketDispatcher _dispatcher;
    private readonly object _lock = new();
    private readonly List<FrameQueue> _queues = [];
    private readonly List<FrameStream> _streams = [];
    private long _droppedByClosedQueues;
    private long _callbackFailures;
    private bool _ended;
    private volatile bool _stopped;

    public ReceivePipeline(SkeletonFormat format, LinkActivity activity, Action<Exception> callbackFailed)
    {
        _format = format;
        _activity = activity;
        _dispatcher = new PacketDispatcher(_counters);
        Callbacks = new FrameCallbacks(format, callbackFailed);
        _dispatcher.Add(Callbacks);
    }

    public FrameCallbacks Callbacks { get; }

    // The thread that is handing out a packet, or 0. Meant to be compared with the calling thread only.
    public int DeliveringThread { get; private set; }

    public void OnPacket(in ReceivedPacket packet)
    {
        if (_stopped)
            return;

        DeliveringThread = Environment.CurrentManagedThreadId;
        _activity.BeginDelivery(packet);
        try
        {
            _dispatcher.Dispatch(packet);
        }
        finally
        {
            _activity.EndDelivery();
            DeliveringThread = 0;
        }
    }

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        if (_stopped)
            return;

        _counters.CountSkipped(bytes.Length, reason);
        _activity.OnSkipped(bytes, reason);
    }

    public void OnLinkOpened() => _counters.Resume();

    // From here on nothing is delivered, even where the receive thread still holds bytes.
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

    public FrameQueue OpenQueue(int capacity)
    {
        var queue = new FrameQueue(capacity, _format, closed => Close(closed, closed));
        Open(queue, queue);
        return queue;
    }

    public LatestFrames OpenLatest()
    {
        var latest = new LatestFrames(_format, _dispatcher.Remove);
        _dispatcher.Add(latest);
        return latest;
    }

    public FrameStream OpenStream(PacketKind kind, out FrameQueue queue)
    {
        FrameStream? stream = null;
        queue = new FrameQueue(FrameQueue.DefaultCapacity, _format, closed => Close(closed, stream!));
        stream = new FrameStream(queue, kind);
        Open(queue, stream);
        return stream;
    }

    public ReaderStatistics GetStatistics()
    {
        lock (_lock)
        {
            return _counters.Snapshot() with
            {
                Dropped = _droppedByClosedQueues + _queues.Sum(static queue => queue.Dropped),
                CallbackFailures = Volatile.Read(ref _callbackFailures),
            };
        }
    }

    public IReadOnlyList<AvatarStatistics> GetAvatarStatistics() => [.. _counters.Trackers.Select(static tracker => tracker.Snapshot)];

    public void CountCallbackFailure() => Interlocked.Increment(ref _callbackFailures);

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
                _droppedByClosedQueues += queue.Dropped;
            if (consumer is FrameStream stream)
                _streams.Remove(stream);
        }
    }
}
