using NeuronMocap.Commands;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Compatibility.Callbacks;

// Gives packets of one connection to the callbacks, as images in unmanaged memory. Receive thread only.
internal sealed class PacketDelivery(IVendorCallbacks callbacks)
{
    private readonly PacketMemory _memory = new();
    private readonly FrameCounter _motionCounter = new();
    private readonly FrameCounter _calculationCounter = new();

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

        callbacks.OnFrame(socket, _memory.Address, _memory.Address + ProtocolConstants.HeaderSize);
        GC.KeepAlive(_memory);
    }

    public void Deliver(IntPtr socket, CalculationFrame frame)
    {
        if (!callbacks.WantsCalculation)
            return;

        Span<byte> image = Copy(frame.Packet);
        if (frame.FrameIndex is null)
            (frame.Header with { Version = DataVersion.Calculation, FrameIndex = _calculationCounter.Next(frame.Source, frame.AvatarIndex) }).Write(image);

        callbacks.OnCalculation(socket, _memory.Address, _memory.Address + ProtocolConstants.HeaderSize);
        GC.KeepAlive(_memory);
    }

    // What follows the header has an address only where something does.
    public void Deliver(IntPtr socket, DataCommandReply reply)
    {
        if (!callbacks.WantsCommands)
            return;

        Copy(reply.Packet.Span);
        callbacks.OnCommand(socket, _memory.Address, reply.Payload.IsEmpty ? IntPtr.Zero : _memory.Address + ProtocolConstants.HeaderSize);
        GC.KeepAlive(_memory);
    }

    // The reserved fields have other meanings in the two layouts: a timecode would be read as IsCompressed.
    private static MotionHeader OldHeaderOf(MotionHeader header) => header.Version != DataVersion.None && header.Layout == HeaderLayout.Old
        ? header
        : header with { Version = DataVersion.Old, Reserved1 = 0, Reserved2 = 0 };

    // Programs may keep the address, and look at a frame after their callback: it stays that of the newest one.
    private Span<byte> Copy(ReadOnlySpan<byte> packet)
    {
        Span<byte> image = _memory.Take(packet.Length);
        packet.CopyTo(image);
        return image;
    }
}
