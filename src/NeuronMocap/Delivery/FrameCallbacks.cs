using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Handlers that run on the receive thread, on frames that still lie in the receive buffer: the shortest way, for handlers that do not wait.
// A handler that does makes the connection wait too, and loses nothing.
internal sealed class FrameCallbacks(FrameFormat format, Action<Exception> failed) : IPacketConsumer
{
    private readonly MotionFrame _motion = new(format);
    private readonly CalculationFrame _calculation = new();
    private readonly StudioCalculationFrame _studio = new();

    public HandlerList<MotionFrame> Motion { get; } = new(failed);

    public HandlerList<CalculationFrame> Calculation { get; } = new(failed);

    public HandlerList<StudioCalculationFrame> StudioCalculation { get; } = new(failed);

    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.Kind == PacketKind.Motion)
        {
            Call(Motion, _motion, packet);
        }
        else if (packet.Kind == PacketKind.Calculation)
        {
            Call(Calculation, _calculation, packet);
        }
        else
        {
            Call(StudioCalculation, _studio, packet);
        }
    }

    private static void Call<TFrame>(HandlerList<TFrame> handlers, TFrame frame, in ReceivedPacket packet)
        where TFrame : AvatarFrame
    {
        if (handlers.IsEmpty)
            return;

        frame.Borrow(packet);
        handlers.Invoke(frame);
    }
}
