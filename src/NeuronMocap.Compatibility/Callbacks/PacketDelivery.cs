using System.Runtime.InteropServices;
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

    public void Deliver(IntPtr socket, MotionFrame frame)
    {
        if (!callbacks.WantsFrames)
            return;

        MotionHeader header = callbacks.FrameHeaders == HeaderLayout.Old ? OldHeaderOf(frame.Header) : NewHeaderOf(frame);
        header.Write(Take(frame.Values));
        callbacks.OnFrame(socket, _memory.Address, _memory.Address + ProtocolConstants.HeaderSize);
        GC.KeepAlive(_memory);
    }

    public void Deliver(IntPtr socket, CalculationFrame frame)
    {
        if (!callbacks.WantsCalculation)
            return;

        CalculationHeader header = frame.Header;
        if (frame.FrameIndex is null)
            header = header with { Version = DataVersion.Calculation, FrameIndex = _calculationCounter.Next(frame.Source, frame.AvatarIndex) };

        header.Write(Take(frame.Values));
        callbacks.OnCalculation(socket, _memory.Address, _memory.Address + ProtocolConstants.HeaderSize);
        GC.KeepAlive(_memory);
    }

    // What follows the header has an address only where something does.
    public void Deliver(IntPtr socket, DataCommandReply reply)
    {
        if (!callbacks.WantsCommands)
            return;

        reply.Packet.Span.CopyTo(_memory.Take(reply.Packet.Length));
        callbacks.OnCommand(socket, _memory.Address, reply.Payload.IsEmpty ? IntPtr.Zero : _memory.Address + ProtocolConstants.HeaderSize);
        GC.KeepAlive(_memory);
    }

    // The reserved fields have other meanings in the two layouts: a timecode would be read as IsCompressed.
    private static MotionHeader OldHeaderOf(MotionHeader header) => header.Version != DataVersion.None && header.Layout == HeaderLayout.Old
        ? header
        : header with { Version = DataVersion.Old, Reserved1 = 0, Reserved2 = 0 };

    private MotionHeader NewHeaderOf(MotionFrame frame) => frame.FrameIndex is null
        ? frame.Header with { Version = DataVersion.New, FrameIndex = _motionCounter.Next(frame.Source, frame.AvatarIndex) }
        : frame.Header;

    // Room for the header, with the values behind it.
    private Span<byte> Take(ReadOnlySpan<float> values)
    {
        ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes(values);
        Span<byte> packet = _memory.Take(ProtocolConstants.HeaderSize + bytes.Length);
        bytes.CopyTo(packet[ProtocolConstants.HeaderSize..]);
        return packet;
    }
}
