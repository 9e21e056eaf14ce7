using System.Diagnostics.CodeAnalysis;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Compatibility.Callbacks;

// Unmanaged memory for one packet. Callbacks receive its address, which never changes, so it has room for the largest packet from the start. Pages
// that no packet uses take no physical memory. The memory is freed when nothing refers to it any more, not when its connection is closed: a callback
// may still be reading it then.
internal sealed unsafe class PacketMemory
{
    private const int Capacity = ProtocolConstants.HeaderSize + ProtocolConstants.MaxCommandPayload;

    [SuppressMessage("Design", "MA0055", Justification = "A safe handle would have to be counted up and down around each callback.")]
    ~PacketMemory() => Marshal.FreeHGlobal(Address);

    // Zero until the first packet, because most connections of some programs never receive one.
    public IntPtr Address { get; private set; }

    // Overwrites the previous packet.
    public Span<byte> Take(int length)
    {
        if (length > Capacity)
            throw new ArgumentOutOfRangeException(nameof(length), length, "The length exceeds the largest packet.");

        if (Address == IntPtr.Zero)
            Address = Marshal.AllocHGlobal(Capacity);

        return new Span<byte>((void*)Address, length);
    }
}
