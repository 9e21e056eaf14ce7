using NeuronMocap.Delivery;

namespace NeuronMocap.Reader;

// Opens and closes the consumers of a reader.
internal sealed partial class ReceivePipeline
{
    private const string StreamName = "stream";

    private static readonly FrameQueueOptions DefaultQueue = new();

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

        delivery = new FrameDelivery(options, source, clock, ended =>
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

    private FrameQueue CreateQueue(FrameQueueOptions options, PacketKind only, Func<bool>? backPressure) =>
        new(options.Capacity, _format, Close, options.Name!, _metrics.HandOver(options.Name!), backPressure, options.WhenFull, options.Thinning.CreateThinner())
        {
            OnlyKind = only,
        };

    // A stop ends every wait, because the reader may be disposed on the thread that would have made room. So does the end of a playback. Null for no wait.
    // Whoever makes room may wait for a frame of another queue.
    private Func<bool>? BackPressureFor(WhenFull whenFull)
    {
        if (_mayWait is { } mayWait)
            return () => MayWait() && mayWait(whenFull);

        return whenFull == WhenFull.Wait ? MayWait : null;

        bool MayWait()
        {
            _dispatcher.Show();
            return !_stopped;
        }
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
