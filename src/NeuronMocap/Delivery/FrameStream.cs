using System.Diagnostics.CodeAnalysis;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// A queue that can be awaited: behind the asynchronous enumerations. Frames are copied out, because code that awaits keeps them.
[SuppressMessage("Design", "CA1001", Justification = "The semaphore holds no handle, and the receive thread may release it after the end.")]
internal sealed class FrameStream(FrameQueue queue, PacketKind kind) : IPacketConsumer
{
    private readonly SemaphoreSlim _signal = new(0);
    private readonly Queue<AvatarFrame> _taken = new();
    private int _waiting;
    private volatile bool _ended;

    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.Kind != kind)
            return;

        ((IPacketConsumer)queue).OnPacket(packet);
        Wake();
    }

    // No more packets will come; those that wait are still given out.
    public void End()
    {
        _ended = true;
        Wake();
    }

    // Null at the end.
    public async ValueTask<AvatarFrame?> ReadAsync(CancellationToken cancellation)
    {
        while (true)
        {
            if (_taken.TryDequeue(out AvatarFrame? frame))
                return frame;

            bool ended = _ended;
            int taken = queue.Pump(
                motion => _taken.Enqueue(motion.Clone()),
                calculation => _taken.Enqueue(calculation.Clone()),
                studio => _taken.Enqueue(studio.Clone()),
                maxFrames: 16);
            if (taken > 0)
                continue;
            if (ended)
                return null;

            // Announce the wait, then look once more: a packet that came before the announcement has not released the signal.
            Interlocked.Exchange(ref _waiting, 1);
            if (queue.Count == 0 && !_ended)
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
