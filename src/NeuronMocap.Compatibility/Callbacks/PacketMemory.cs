using System.Diagnostics.CodeAnalysis;
using System.Runtime.InteropServices;

namespace NeuronMocap.Compatibility.Callbacks;

// Unmanaged memory for one packet, whose address callbacks are given. It is freed when nothing refers to it any more, not when its connection
// is closed: a callback may be reading it then.
internal sealed unsafe class PacketMemory
{
    private int _capacity;

    [SuppressMessage("Design", "MA0055", Justification = "A safe handle would have to be replaced whenever a packet is larger.")]
    ~PacketMemory() => Marshal.FreeHGlobal(Address);

    public IntPtr Address { get; private set; }

    // Makes room. What was there before, and where, is forgotten when it was too small.
    public Span<byte> Take(int length)
    {
        if (length > _capacity)
            Grow(Math.Max(length, 2 * _capacity));

        return new Span<byte>((void*)Address, length);
    }

    private void Grow(int capacity)
    {
        Marshal.FreeHGlobal(Address);
        Address = IntPtr.Zero;
        _capacity = 0;
        Address = Marshal.AllocHGlobal(capacity);
        _capacity = capacity;
    }
}
