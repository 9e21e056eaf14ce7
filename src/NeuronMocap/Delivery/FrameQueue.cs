using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>
/// A bounded queue of frames, in order, for one thread of the application. The receive thread adds frames, and does not wait unless
/// <see cref="WhenFull.Wait"/> is chosen. The application takes them out when it calls <c>Pump</c>, for example in its main loop.
/// </summary>
/// <remarks>
/// <para>
/// When the queue is full, arriving frames are dropped and counted in <see cref="Dropped"/>; waiting frames are kept. Other queues and the connection are
/// not affected. <see cref="FrameQueueOptions.WhenFull"/> chooses otherwise. Only one thread at a time may pump. A thread with no other work can wait for
/// frames with <see cref="Wait"/>, and asynchronous code with <see cref="WaitAsync"/>.
/// </para>
/// <para>
/// The queue allocates its memory when it is opened: 1.5 KB for each frame of its capacity. A slot grows once when it first holds a larger packet, such as
/// calculation data of 3.8 KB.
/// </para>
/// </remarks>
public sealed partial class FrameQueue : IPacketConsumer, ICountedConsumer, IDisposable
{
    internal const string DefaultName = "queue";
    internal const int MaxCapacity = 1 << 20;

    /// <summary>The default capacity: 4 s of one avatar at 120 Hz, about 0.8 MB.</summary>
    public const int DefaultCapacity = 512;

    // Holds the largest motion packet, of 360 values, in whole cache lines.
    private const int SlotSize = 1536;

    // One of the two: the second one drops its oldest packets.
    private readonly PacketRing? _ring;
    private readonly DroppingRing? _droppingRing;
    private readonly FramePool _frames;
    private readonly Action<FrameQueue> _closed;
    private readonly IDurationRecorder? _handOver;
    private readonly Func<bool>? _backPressure;
    private readonly FrameThinner? _thinner;
    private long _dropped;
    private int _pumping;
    private volatile bool _isComplete;
    private volatile bool _disposed;

    // backPressure: tells whether the producer may wait for room. An unpaced playback can wait.
    // thinner: null for every frame.
    internal FrameQueue(
        int capacity,
        FrameFormat format,
        Action<FrameQueue> closed,
        string name = DefaultName,
        IDurationRecorder? handOver = null,
        Func<bool>? backPressure = null,
        WhenFull whenFull = WhenFull.DropNewest,
        FrameThinner? thinner = null)
    {
        if (capacity is < 1 or > MaxCapacity)
            throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "The capacity must be 1 to 1,048,576 frames.");

        if (whenFull == WhenFull.DropOldest)
            _droppingRing = new DroppingRing(capacity, SlotSize);
        else
            _ring = new PacketRing(capacity, SlotSize);

        _frames = new FramePool(format, FramePool.OfHandlers);
        _frames.Prepare(PacketKind.Motion);
        _closed = closed;
        _handOver = handOver;
        _backPressure = backPressure;
        _thinner = thinner;
        Name = name;
    }

    /// <summary>Name of the queue in metrics and logs: the name it was opened with, or "queue".</summary>
    public string Name { get; }

    /// <summary>Largest number of frames that can wait: the requested capacity, rounded up to a power of two.</summary>
    public int Capacity => _ring?.Capacity ?? _droppingRing!.Capacity;

    /// <summary>Number of waiting frames. Thread-safe.</summary>
    public int Count => _ring?.Count ?? _droppingRing!.Count;

    /// <summary>Number of frames that were dropped because the queue was full. Thread-safe.</summary>
    public long Dropped => Volatile.Read(ref _dropped) + (_droppingRing?.Dropped ?? 0);

    /// <summary>
    /// Number of frames that were not added because of <see cref="FrameQueueOptions.MaxRate"/> or <see cref="FrameQueueOptions.EveryNth"/>. Thread-safe.
    /// </summary>
    public long Skipped => _thinner?.Skipped ?? 0;

    /// <summary>
    /// Number of frames that were taken out. Together with <see cref="Dropped"/>, <see cref="Skipped"/> and <see cref="Count"/>, it equals the number of
    /// frames that arrived since the queue was opened. A frame that is being added, or waits for room, is not in it yet. Thread-safe.
    /// </summary>
    public long Delivered => _ring?.Released ?? _droppingRing!.Taken;

    // The only kind of frame that is added; None for all kinds.
    internal PacketKind OnlyKind { get; init; }

    /// <summary>
    /// Calls a handler for every waiting frame, oldest first, on this thread. Returns at once if no frame waits. Frames that arrive during the call are
    /// included, up to the limit.
    /// </summary>
    /// <typeparam name="TFrame">
    /// The kind of frame that the handler takes, such as <see cref="MotionFrame"/>. Frames of other kinds are taken out and skipped. With
    /// <see cref="AvatarFrame"/> the handler gets frames of all kinds.
    /// </typeparam>
    /// <param name="handler">Called with each frame. The frame is valid during the call.</param>
    /// <param name="maxFrames">Largest number of frames to take out, so that a backlog cannot delay the caller.</param>
    /// <returns>Number of frames taken out.</returns>
    /// <exception cref="InvalidOperationException">Another thread is pumping this queue, or a handler of this queue pumps it.</exception>
    /// <remarks>
    /// An exception of a handler is thrown out of this call, and its frame counts as taken out. A lambda that captures a variable or <c>this</c> allocates
    /// a new object in every call. Keep the delegate in a field, or use the overload that takes a state.
    /// </remarks>
    public int Pump<TFrame>(Action<TFrame> handler, int maxFrames = int.MaxValue)
        where TFrame : AvatarFrame
    {
        ArgumentNullException.ThrowIfNull(handler);
        return Pump<TFrame, Action<TFrame>>(handler, static (handler, frame) => handler(frame), maxFrames);
    }

    /// <summary>
    /// Calls a handler with a state for every waiting frame. With a <c>static</c> lambda, which captures nothing, the call allocates nothing.
    /// </summary>
    /// <typeparam name="TFrame">
    /// The kind of frame that the handler takes; otherwise the same as for <see cref="Pump{TFrame}(Action{TFrame}, int)"/>.
    /// </typeparam>
    /// <typeparam name="TState">Type of the state.</typeparam>
    /// <param name="state">The data that the handler needs: an object, or a tuple of several.</param>
    /// <param name="handler">Called with the state and each frame. The frame is valid during the call.</param>
    /// <param name="maxFrames">Largest number of frames to take out, so that a backlog cannot delay the caller.</param>
    /// <returns>Number of frames taken out.</returns>
    /// <exception cref="InvalidOperationException">Another thread is pumping this queue, or a handler of this queue pumps it.</exception>
    /// <remarks>An exception of a handler is thrown out of this call, and its frame counts as taken out.</remarks>
    public int Pump<TFrame, TState>(TState state, Action<TState, TFrame> handler, int maxFrames = int.MaxValue)
        where TFrame : AvatarFrame
    {
        ArgumentNullException.ThrowIfNull(handler);
        if (Interlocked.Exchange(ref _pumping, 1) != 0)
            throw new InvalidOperationException("Only one thread at a time may pump a queue, and its handlers must not pump it. Open a queue for each thread.");

        AvatarFrame? lent = null;
        try
        {
            int taken = 0;
            while (taken < maxFrames && !_disposed && TryTake(out ReceivedPacket packet))
            {
                taken++;
                if (_handOver is { IsEnabled: true })
                    _handOver.Record(packet.Kind, Stopwatch.GetTimestamp() - packet.Timestamp);

                lent = _frames.Lend(packet);
                if (lent is TFrame frame)
                    handler(state, frame);

                lent.Expire();
                lent = null;
                _ring?.Release();
            }

            return taken;
        }
        finally
        {
            // The handler threw. If there was no memory for a frame, its packet stays in the queue.
            if (lent is not null)
            {
                lent.Expire();
                _ring?.Release();
            }

            Volatile.Write(ref _pumping, 0);
        }
    }

    /// <summary>Removes the queue from its reader and discards the waiting frames. Any thread, any number of times.</summary>
    public void Dispose()
    {
        if (_disposed)
            return;

        _disposed = true;
        _closed(this);
        _signal?.Set();
    }

    // Stops adding frames. Waiting frames can still be taken out.
    internal void CompleteAdding()
    {
        _isComplete = true;
        Changed?.Invoke();
    }

    void ICountedConsumer.CompleteAdding() => CompleteAdding();

    void IPacketConsumer.OnPacket(in ReceivedPacket packet)
    {
        if (_isComplete || (OnlyKind != PacketKind.None && packet.Kind != OnlyKind))
            return;
        if (_thinner is { } thinner && !thinner.Takes(packet))
            return;

        if (_ring is not { } ring)
            StoreDroppingOldest(packet);
        else if (!ring.TryEnqueue(packet) && !(WaitForRoom() && ring.TryEnqueue(packet)))
            Volatile.Write(ref _dropped, _dropped + 1);

        OnAdded();
    }

    // A packet of the first ring is in use until Release, and one of the second ring until the next call.
    private bool TryTake(out ReceivedPacket packet) => _ring is { } ring ? ring.TryPeek(out packet) : _droppingRing!.TryTake(out packet);

    private void StoreDroppingOldest(in ReceivedPacket packet)
    {
        if (Count == Capacity)
            WaitForRoom();

        _droppingRing!.Store(packet);
    }

    // Returns false if the producer may not wait, or no longer. It polls instead of waiting for a signal, so the consumer never has to send one, and
    // whatever ends the wait needs no thread. The caller is the only producer, so the room stays free.
    private bool WaitForRoom()
    {
        if (_backPressure is not { } mayWait)
            return false;

        var wait = new SpinWait();
        while (Count == Capacity)
        {
            if (_disposed || !mayWait())
                return false;

            wait.SpinOnce();
        }

        return true;
    }
}
