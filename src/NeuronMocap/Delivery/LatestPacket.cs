using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// The newest packet of one avatar. One producer and one consumer exchange three slots. Neither waits, no packet is torn, and none is queued.
//
// Each slot has one owner at any moment: the producer fills one, the consumer reads one, and one is shared between them. A flag in the shared index says
// whether the consumer has yet to see that slot. Interlocked.Exchange swaps an owned index for the shared one and is a full fence on every runtime. Data
// that the producer writes before its swap is therefore visible to the consumer after the consumer's own swap.
internal sealed class LatestPacket(int slotSize)
{
    private const int Fresh = 4;
    private const int IndexMask = 3;

    private readonly PacketSlots _slots = new(3, slotSize);
    private Owners _owners = new() { Producers = 0, Shared = 1, Consumers = 2 };

    // Whether a packet was published that the consumer has not taken. Any thread.
    public bool IsFresh => (Volatile.Read(ref _owners.Shared) & Fresh) != 0;

    // Producer. Returns true if the packet replaced one that the consumer has not taken.
    public bool Publish(in ReceivedPacket packet)
    {
        _slots.Store(_owners.Producers, packet);
        int replaced = Interlocked.Exchange(ref _owners.Shared, _owners.Producers | Fresh);
        _owners.Producers = replaced & IndexMask;
        return (replaced & Fresh) != 0;
    }

    // Consumer. Returns false if nothing was published since the last call that returned true. The packet of that call then stays valid.
    public bool TryTake(out ReceivedPacket packet)
    {
        if (!IsFresh)
        {
            packet = default;
            return false;
        }

        _owners.Consumers = Interlocked.Exchange(ref _owners.Shared, _owners.Consumers) & IndexMask;
        packet = _slots[_owners.Consumers];
        return true;
    }

    [StructLayout(LayoutKind.Explicit, Size = 512)]
    private struct Owners
    {
        [FieldOffset(128)]
        public int Producers;

        [FieldOffset(256)]
        public int Shared;

        [FieldOffset(384)]
        public int Consumers;
    }
}
