using System.Diagnostics.CodeAnalysis;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Compatibility.Callbacks;

// Unmanaged memory for one packet, whose address callbacks are given. It has room for every packet from the beginning, as its address stays; what no
// packet touches takes no memory of the system. It is freed when nothing refers to it any more, not when its connection is closed: a callback may be
// reading it then.
internal sealed unsafe class PacketMemory
{
    private const int Capacity = ProtocolConstants.HeaderSize + ProtocolConstants.MaxCommandPayload;

    [SuppressMessage("Design", "MA0055", Justification = "A safe handle is to be counted up and down around each callback.")]
    ~PacketMemory() => Marshal.FreeHGlobal(Address);

    // Zero until the first packet: most connections of some programs never have one.
    public IntPtr Address { get; private set; }

    // What was there before is overwritten.
    public Span<byte> Take(int length)
    {
        if (length > Capacity)
            throw new ArgumentOutOfRangeException(nameof(length), length, "No packet is as large as that.");

        if (Address == IntPtr.Zero)
            Address = Marshal.AllocHGlobal(Capacity);

        return new Span<byte>((void*)Address, length);
    }
}
