using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// The newest packet of one avatar: three slots that one producer and one consumer exchange, so that neither waits, no packet is torn and
// none is queued.
//
// At any moment each slot has one owner: the producer's to fill, the consumer's to read, and the shared one between them. The shared index
// carries a flag that says whether the consumer has yet to see it. Interlocked.Exchange swaps an owned index for the shared one and is a
// full fence on every runtime, so what the producer wrote before its swap is visible to the consumer after its own.
internal sealed class LatestPacket(int slotSize)
{
    private const int Fresh = 4;
    private const int IndexMask = 3;

    private readonly PacketSlots _slots = new(3, slotSize);
    private Owners _owners = new() { Producers = 0, Shared = 1, Consumers = 2 };

    // Producer.
    public void Publish(in ReceivedPacket packet)
    {
        _slots.Store(_owners.Producers, packet);
        _owners.Producers = Interlocked.Exchange(ref _owners.Shared, _owners.Producers | Fresh) & IndexMask;
    }

    // Consumer. False when nothing was published since the last call that returned true; that call's packet then stays valid.
    public bool TryTake(out ReceivedPacket packet)
    {
        if ((Volatile.Read(ref _owners.Shared) & Fresh) == 0)
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
