using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Runs handlers on the receive thread, on frames that still lie in the receive buffer. This is the shortest way, for handlers that do not wait.
// A handler that waits makes the connection wait too; over TCP nothing is lost.
internal sealed class FrameCallbacks : IPacketConsumer
{
    private readonly FramePool _frames;
    private readonly HandlerThread _thread;
    private readonly IFrameHandlers?[] _handlers = new IFrameHandlers?[(int)PacketKind.StudioCalculation + 1];

    public FrameCallbacks(FrameFormat format, Action<Exception> failed, HandlerThread thread)
    {
        _thread = thread;
        _frames = new FramePool(format, FramePool.OfHandlers);
        _frames.Prepare(PacketKind.Motion);
        _handlers[(int)PacketKind.Motion] = Motion = new FrameHandlers<MotionFrame>(failed);
        _handlers[(int)PacketKind.Calculation] = Calculation = new FrameHandlers<CalculationFrame>(failed);
        _handlers[(int)PacketKind.StudioCalculation] = StudioCalculation = new FrameHandlers<StudioCalculationFrame>(failed);
    }

    public FrameHandlers<MotionFrame> Motion { get; }

    public FrameHandlers<CalculationFrame> Calculation { get; }

    public FrameHandlers<StudioCalculationFrame> StudioCalculation { get; }

    public void OnPacket(in ReceivedPacket packet)
    {
        IFrameHandlers handlers = _handlers[(int)packet.Kind]!;
        if (handlers.IsEmpty)
            return;

        AvatarFrame frame = _frames.Lend(packet);
        _thread.Enter();
        handlers.Invoke(frame);
        _thread.Leave();
        frame.Expire();
    }
}
