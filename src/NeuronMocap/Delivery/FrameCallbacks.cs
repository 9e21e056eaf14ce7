using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Delivery;

// Handlers that run on the receive thread, on frames that still lie in the receive buffer: the shortest way, for handlers that do not wait.
// A handler that does makes the connection wait too, and loses nothing.
internal sealed class FrameCallbacks(SkeletonFormat format, Action<Exception> failed) : IPacketConsumer
{
    private readonly MotionFrame _motion = new(format);
    private readonly CalculationFrame _calculation = new();

    public HandlerList<MotionFrame> Motion { get; } = new(failed);

    public HandlerList<CalculationFrame> Calculation { get; } = new(failed);

    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.Kind == PacketKind.Motion)
        {
            if (Motion.IsEmpty)
                return;

            _motion.Borrow(packet);
            Motion.Invoke(_motion);
        }
        else if (!Calculation.IsEmpty)
        {
            _calculation.Borrow(packet);
            Calculation.Invoke(_calculation);
        }
    }
}
