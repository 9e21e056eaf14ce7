using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>
/// Every frame, in order, for one thread of the application: the receive thread puts frames in without ever waiting, and the application
/// takes them out when it calls <c>Pump</c>, in its main loop for example.
/// <para>
/// The queue is bounded. When the application is late and the queue is full, the frames that arrive are dropped and counted in
/// <see cref="Dropped"/>; those that wait are kept. A queue loses only its own frames: other queues and the connection go on.
/// One thread at a time may pump. Memory is allocated when the queue is made, 1.5 KB for each frame of its capacity; a place that first holds
/// a larger packet, such as calculation data of 3.8 KB, grows to it once.
/// </para>
/// </summary>
public sealed class FrameQueue : IPacketConsumer, IDisposable
{
    internal const string DefaultName = "queue";

    /// <summary>Capacity unless another is asked for: 4 s of one avatar at 120 Hz, about 0.8 MB.</summary>
    public const int DefaultCapacity = 512;

    // Holds a motion packet of 360 values, the largest, in whole cache lines.
    private const int SlotSize = 1536;

    private readonly PacketRing _ring;
    private readonly FramePool _frames;
    private readonly Action<FrameQueue> _closed;
    private readonly IDurationRecorder? _handOver;
    private readonly Func<bool>? _backPressure;
    private long _dropped;
    private int _pumping;
    private volatile bool _isComplete;
    private volatile bool _disposed;

    // BackPressure: whether the producer may wait for room, as an unpaced playback can.
    internal FrameQueue(
        int capacity,
        FrameFormat format,
        Action<FrameQueue> closed,
        string name = DefaultName,
        IDurationRecorder? handOver = null,
        Func<bool>? backPressure = null)
    {
        if (capacity is < 1 or > 1 << 20)
            throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "A queue holds 1 to 1,048,576 frames.");

        _ring = new PacketRing(capacity, SlotSize);
        _frames = new FramePool(format, FramePool.OfHandlers);
        _frames.Prepare(PacketKind.Motion);
        _closed = closed;
        _handOver = handOver;
        _backPressure = backPressure;
        Name = name;
    }

    /// <summary>What metrics and logs call it: the name it was opened with, or "queue".</summary>
    public string Name { get; }

    /// <summary>Largest number of frames that can wait: the asked-for number, rounded up to a power of two.</summary>
    public int Capacity => _ring.Capacity;

    /// <summary>Number of frames that wait. Any thread.</summary>
    public int Count => _ring.Count;

    /// <summary>Number of frames that were dropped because the queue was full. Any thread.</summary>
    public long Dropped => Volatile.Read(ref _dropped);

    /// <summary>
    /// Number of frames that were taken out. With <see cref="Dropped"/> and <see cref="Count"/> it makes up all frames that arrived since the queue was
    /// opened. Any thread.
    /// </summary>
    public long Delivered => _ring.Released;

    // The only kind of frame that is put in; None for all.
    internal PacketKind OnlyKind { get; init; }

    // Called on the receive thread after each frame, and when adding is completed. Set before the queue gets its first frame.
    internal Action? Changed { get; set; }

    internal bool IsAddingCompleted => _isComplete;

    /// <summary>
    /// Runs a handler for every waiting frame, oldest first, on this thread; returns at once when none waits. Frames that arrive meanwhile
    /// are included, up to the limit.
    /// </summary>
    /// <typeparam name="TFrame">
    /// The kind of frame that the handler takes, such as <see cref="MotionFrame"/>. Frames of other kinds are taken out and passed over. With
    /// <see cref="AvatarFrame"/> the handler gets frames of all kinds.
    /// </typeparam>
    /// <param name="handler">Called with each frame. The frame is valid during the call.</param>
    /// <param name="maxFrames">Return after this many frames, so that a backlog cannot hold up the caller.</param>
    /// <returns>Number of frames taken out.</returns>
    /// <exception cref="InvalidOperationException">Another thread is pumping this queue, or a handler pumps it.</exception>
    /// <remarks>
    /// An exception of a handler comes out of this call; the frame it was called with counts as taken. A lambda that captures a variable or <c>this</c> is a new
    /// object in every call, which C# allocates. Keep the delegate in a field, or use the overload that takes a state.
    /// </remarks>
    public int Pump<TFrame>(Action<TFrame> handler, int maxFrames = int.MaxValue)
        where TFrame : AvatarFrame
    {
        ArgumentNullException.ThrowIfNull(handler);
        return Pump<TFrame, Action<TFrame>>(handler, static (handler, frame) => handler(frame), maxFrames);
    }

    /// <summary>
    /// Runs a handler for every waiting frame, and gives it a state. With a lambda that is <c>static</c>, and so captures nothing, the call allocates nothing.
    /// </summary>
    /// <typeparam name="TFrame">The kind of frame that the handler takes; otherwise as for <see cref="Pump{TFrame}(Action{TFrame}, int)"/>.</typeparam>
    /// <typeparam name="TState">Type of the state.</typeparam>
    /// <param name="state">What the handler needs: an object of yours, or a tuple of several.</param>
    /// <param name="handler">Called with the state and each frame. The frame is valid during the call.</param>
    /// <param name="maxFrames">Return after this many frames, so that a backlog cannot hold up the caller.</param>
    /// <returns>Number of frames taken out.</returns>
    /// <exception cref="InvalidOperationException">Another thread is pumping this queue, or a handler pumps it.</exception>
    /// <remarks>An exception of a handler comes out of this call; the frame it was called with counts as taken.</remarks>
    public int Pump<TFrame, TState>(TState state, Action<TState, TFrame> handler, int maxFrames = int.MaxValue)
        where TFrame : AvatarFrame
    {
        ArgumentNullException.ThrowIfNull(handler);
        if (Interlocked.Exchange(ref _pumping, 1) != 0)
            throw new InvalidOperationException("One thread at a time may pump a queue, and its handlers may not. Open a queue for each thread.");

        try
        {
            int taken = 0;
            while (taken < maxFrames && !_disposed && _ring.TryPeek(out ReceivedPacket packet))
            {
                taken++;
                if (_handOver is { IsEnabled: true })
                    _handOver.Record(packet.Kind, Stopwatch.GetTimestamp() - packet.Timestamp);

                AvatarFrame? lent = null;
                try
                {
                    lent = _frames.Lend(packet);
                    if (lent is TFrame frame)
                        handler(state, frame);
                }
                finally
                {
                    lent?.Expire();
                    _ring.Release();
                }
            }

            return taken;
        }
        finally
        {
            Volatile.Write(ref _pumping, 0);
        }
    }

    /// <summary>Takes the queue off its reader; frames that wait are given up. Any thread, any number of times.</summary>
    public void Dispose()
    {
        if (_disposed)
            return;

        _disposed = true;
        _closed(this);
    }

    // Nothing more is put in, and what waits can still be taken out.
    internal void CompleteAdding()
    {
        _isComplete = true;
        Changed?.Invoke();
    }

    void IPacketConsumer.OnPacket(in ReceivedPacket packet)
    {
        if (_isComplete || (OnlyKind != PacketKind.None && packet.Kind != OnlyKind))
            return;

        if (!_ring.TryEnqueue(packet) && !(_backPressure?.Invoke() == true && TryEnqueueLater(packet)))
            Volatile.Write(ref _dropped, _dropped + 1);

        Changed?.Invoke();
    }

    // Looks now and then instead of being woken, so that a live stream's consumer has nobody to wake.
    private bool TryEnqueueLater(in ReceivedPacket packet)
    {
        var wait = new SpinWait();
        while (!_disposed && _backPressure!())
        {
            wait.SpinOnce();
            if (_ring.TryEnqueue(packet))
                return true;
        }

        return false;
    }
}
