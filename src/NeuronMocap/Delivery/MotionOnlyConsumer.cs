using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// In front of a queue of motion alone. Closed, it lets nothing more in while what waits is still taken out.
internal sealed class MotionOnlyConsumer(FrameQueue queue) : IPacketConsumer
{
    private volatile bool _isClosed;

    public void Close() => _isClosed = true;

    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.Kind == PacketKind.Motion && !_isClosed)
            ((IPacketConsumer)queue).OnPacket(packet);
    }
}
