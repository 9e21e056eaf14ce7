using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Handlers that run on the receive thread, on frames that still lie in the receive buffer: the shortest way, for handlers that do not wait.
// A handler that does makes the connection wait too, and loses nothing.
internal sealed class FrameCallbacks(FrameFormat format, Action<Exception> failed) : IPacketConsumer
{
    private readonly LentFrames<MotionFrame> _motion = new(() => new MotionFrame(format), LentFrames<MotionFrame>.OfHandlers);
    private readonly LentFrames<CalculationFrame> _calculation = new(static () => new CalculationFrame(), LentFrames<CalculationFrame>.OfHandlers);
    private readonly LentFrames<StudioCalculationFrame> _studio = new(static () => new StudioCalculationFrame(), LentFrames<StudioCalculationFrame>.OfHandlers);

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

    private static void Call<TFrame>(HandlerList<TFrame> handlers, LentFrames<TFrame> frames, in ReceivedPacket packet)
        where TFrame : AvatarFrame
    {
        if (handlers.IsEmpty)
            return;

        TFrame frame = frames.Lend(packet);
        handlers.Invoke(frame);
        frame.Expire();
    }
}
