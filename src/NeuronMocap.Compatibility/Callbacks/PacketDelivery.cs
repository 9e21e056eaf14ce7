using NeuronMocap.Commands;
using NeuronMocap.Protocol;

namespace NeuronMocap.Compatibility.Callbacks;

// Passes the packets of one connection to the callbacks, as images in unmanaged memory. Receive thread only; thread is its managed number.
internal sealed class PacketDelivery(IVendorCallbacks callbacks, CallbackGate gate)
{
    private readonly PacketMemory _memory = new();
    private readonly FrameCounter _motionCounter = new();
    private readonly FrameCounter _calculationCounter = new();
    private Exception? _reported;

    // The header is that of b15, or that of b12 if the callbacks ask for it. Its version matches, so one struct fits every frame. A packet that
    // already has this header is used as it is.
    public void Deliver(IntPtr socket, int thread, MotionFrame frame)
    {
        if (!callbacks.WantsFrames)
            return;

        Span<byte> image = Copy(frame.Packet);
        if (callbacks.FrameHeaders == HeaderLayout.Old)
            OldHeaderOf(frame.Header).Write(image);
        else if (frame.FrameIndex is null)
            (frame.Header with { Version = DataVersion.New, FrameIndex = _motionCounter.Next(frame.Sender, frame.AvatarIndex) }).Write(image);

        Call(PacketKind.Motion, socket, thread, hasData: true);
    }

    public void Deliver(IntPtr socket, int thread, CalculationFrame frame)
    {
        if (!callbacks.WantsCalculation)
            return;

        Span<byte> image = Copy(frame.Packet);
        if (frame.FrameIndex is null)
            (frame.Header with { Version = DataVersion.Calculation, FrameIndex = _calculationCounter.Next(frame.Sender, frame.AvatarIndex) }).Write(image);

        Call(PacketKind.Calculation, socket, thread, hasData: true);
    }

    // The data pointer is zero if nothing follows the header.
    public void Deliver(IntPtr socket, int thread, DataCommandReply reply)
    {
        if (!callbacks.WantsCommands)
            return;

        Copy(reply.Packet.Span);
        Call(PacketKind.Command, socket, thread, hasData: !reply.Payload.IsEmpty);
    }

    // Whether a callback threw this exception.
    public bool HasReported(Exception exception) => ReferenceEquals(exception, _reported);

    // The reserved fields have different meanings in the two layouts: a timecode would be read as IsCompressed.
    private static MotionHeader OldHeaderOf(MotionHeader header) => header.Version != DataVersion.None && header.Layout == HeaderLayout.Old
        ? header
        : header with { Version = DataVersion.Old, Reserved1 = 0, Reserved2 = 0 };

    // Enters the gate last, so that no callback starts after closing, however long this thread was delayed before.
    private void Call(PacketKind kind, IntPtr socket, int thread, bool hasData)
    {
        if (!gate.TryBeginDelivery(thread))
            return;

        IntPtr header = _memory.Address;
        IntPtr data = hasData ? header + ProtocolConstants.HeaderSize : IntPtr.Zero;
        try
        {
            if (kind == PacketKind.Motion)
                callbacks.OnFrame(socket, header, data);
            else if (kind == PacketKind.Calculation)
                callbacks.OnCalculation(socket, header, data);
            else
                callbacks.OnCommand(socket, header, data);
        }
        catch (Exception exception)
        {
            // Reported before the gate is left, because the handler may also wait for the thread that closes. The exception continues to the reader,
            // which counts it.
            _reported = exception;
            CompatibilityEvents.Report(exception);
            throw;
        }
        finally
        {
            gate.EndDelivery();
            GC.KeepAlive(_memory);
        }
    }

    // Programs may keep the address and read a frame after their callback. While the connection lasts, the address always holds the newest frame.
    private Span<byte> Copy(ReadOnlySpan<byte> packet)
    {
        Span<byte> image = _memory.Take(packet.Length);
        packet.CopyTo(image);
        return image;
    }
}
