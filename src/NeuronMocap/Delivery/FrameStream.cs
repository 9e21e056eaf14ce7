using System.Diagnostics.CodeAnalysis;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// A queue that can be awaited: behind the asynchronous enumerations. Frames are copied out, because code that awaits keeps them.
[SuppressMessage("Design", "CA1001", Justification = "The semaphore holds no handle, and the receive thread may release it after the end.")]
internal sealed class FrameStream : IPacketConsumer
{
    private readonly FrameQueue _queue;
    private readonly PacketKind _kind;
    private readonly SemaphoreSlim _signal = new(0);
    private readonly Queue<AvatarFrame> _taken = new();
    private readonly Action<MotionFrame> _onMotion;
    private readonly Action<CalculationFrame> _onCalculation;
    private readonly Action<StudioCalculationFrame> _onStudioCalculation;
    private int _waiting;
    private volatile bool _ended;

    public FrameStream(FrameQueue queue, PacketKind kind)
    {
        _queue = queue;
        _kind = kind;
        _onMotion = frame => _taken.Enqueue(frame.Clone());
        _onCalculation = frame => _taken.Enqueue(frame.Clone());
        _onStudioCalculation = frame => _taken.Enqueue(frame.Clone());
    }

    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.Kind != _kind)
            return;

        ((IPacketConsumer)_queue).OnPacket(packet);
        Wake();
    }

    // No more packets will come; those that wait are still given out.
    public void End()
    {
        _ended = true;
        Wake();
    }

    // A frame that waits, as a copy; null also where none does.
    public AvatarFrame? TryRead()
    {
        if (_taken.Count == 0)
            _queue.Pump(_onMotion, _onCalculation, _onStudioCalculation, maxFrames: 16);

        return _taken.TryDequeue(out AvatarFrame? frame) ? frame : null;
    }

    // Null at the end.
    public ValueTask<AvatarFrame?> ReadAsync(CancellationToken cancellation) => TryRead() is { } frame ? new(frame) : WaitAsync(cancellation);

    private async ValueTask<AvatarFrame?> WaitAsync(CancellationToken cancellation)
    {
        while (true)
        {
            bool ended = _ended;
            if (TryRead() is { } frame)
                return frame;
            if (ended)
                return null;

            // Announce the wait, then look once more: a packet that came before the announcement has not released the signal.
            Interlocked.Exchange(ref _waiting, 1);
            if (_queue.Count == 0 && !_ended)
                await _signal.WaitAsync(cancellation).ConfigureAwait(false);

            Interlocked.Exchange(ref _waiting, 0);
        }
    }

    private void Wake()
    {
        if (Interlocked.Exchange(ref _waiting, 0) == 1)
            _signal.Release();
    }
}
