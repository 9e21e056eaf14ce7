using NeuronMocap.Commands;
using NeuronMocap.Protocol;

namespace NeuronMocap.Compatibility.Callbacks;

// Gives packets of one connection to the callbacks, as images in unmanaged memory. Receive thread only.
internal sealed class PacketDelivery(IVendorCallbacks callbacks, CallbackGate gate)
{
    private readonly PacketMemory _memory = new();
    private readonly FrameCounter _motionCounter = new();
    private readonly FrameCounter _calculationCounter = new();
    private Exception? _reported;

    // The header is that of b15 unless that of b12 is asked for, and its version says so: one struct fits every frame. Packets that have it are their
    // own images.
    public void Deliver(IntPtr socket, MotionFrame frame)
    {
        if (!callbacks.WantsFrames)
            return;

        Span<byte> image = Copy(frame.Packet);
        if (callbacks.FrameHeaders == HeaderLayout.Old)
            OldHeaderOf(frame.Header).Write(image);
        else if (frame.FrameIndex is null)
            (frame.Header with { Version = DataVersion.New, FrameIndex = _motionCounter.Next(frame.Source, frame.AvatarIndex) }).Write(image);

        Call(PacketKind.Motion, socket, hasData: true);
    }

    public void Deliver(IntPtr socket, CalculationFrame frame)
    {
        if (!callbacks.WantsCalculation)
            return;

        Span<byte> image = Copy(frame.Packet);
        if (frame.FrameIndex is null)
            (frame.Header with { Version = DataVersion.Calculation, FrameIndex = _calculationCounter.Next(frame.Source, frame.AvatarIndex) }).Write(image);

        Call(PacketKind.Calculation, socket, hasData: true);
    }

    // What follows the header has an address only where something does.
    public void Deliver(IntPtr socket, DataCommandReply reply)
    {
        if (!callbacks.WantsCommands)
            return;

        Copy(reply.Packet.Span);
        Call(PacketKind.Command, socket, hasData: !reply.Payload.IsEmpty);
    }

    // Whether a callback threw this exception.
    public bool HasReported(Exception exception) => ReferenceEquals(exception, _reported);

    // The reserved fields have other meanings in the two layouts: a timecode would be read as IsCompressed.
    private static MotionHeader OldHeaderOf(MotionHeader header) => header.Version != DataVersion.None && header.Layout == HeaderLayout.Old
        ? header
        : header with { Version = DataVersion.Old, Reserved1 = 0, Reserved2 = 0 };

    // Enters the gate last of all: no callback begins after closing, however long this thread was held up on its way here.
    private void Call(PacketKind kind, IntPtr socket, bool hasData)
    {
        if (!gate.TryBeginDelivery())
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
            // Before the gate is left: whoever is told may wait for the thread that closes, too. Goes on to the reader, which counts it.
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

    // Programs may keep the address, and look at a frame after their callback: it stays that of the newest one while the connection lasts.
    private Span<byte> Copy(ReadOnlySpan<byte> packet)
    {
        Span<byte> image = _memory.Take(packet.Length);
        packet.CopyTo(image);
        return image;
    }
}
