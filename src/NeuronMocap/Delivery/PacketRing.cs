using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// A bounded queue between one producer (the receive thread) and one consumer (a thread of the application), without locks or allocations.
//
// Both indices count up without end; the slot is the index modulo the capacity, a power of two. Only the producer writes the tail, and only the consumer
// writes the head. The producer fills a slot and then publishes the tail with a release. A consumer that reads the new tail with an acquire therefore sees
// the filled slot. The consumer finishes with a slot before it publishes the head with a release. The producer fills that slot only after it reads the
// head with an acquire. Each side keeps a copy of the other's index and reads it again only when the copy says full or empty. The indices are ints,
// because 32-bit processors read an int in one piece. The indices of the two sides lie 128 bytes apart, so the two cores do not compete for a cache line.
// One line would not be enough, because some processors fetch lines in pairs.
internal sealed class PacketRing
{
    private readonly PacketSlots _slots;
    private readonly int _mask;
    private Indices _indices;

    // Tests start close to the wrap-around of the indices.
    public PacketRing(int capacity, int slotSize, int firstIndex = 0)
    {
        int size = 1;
        while (size < capacity)
            size *= 2;

        _mask = size - 1;
        _slots = new PacketSlots(size, slotSize);
        _indices.Tail = _indices.ProducersHead = _indices.Head = _indices.ConsumersTail = firstIndex;
    }

    public int Capacity => _slots.Count;

    // Any thread; exact only while both sides are idle. Reads the head first, because the head never passes a tail that is read later.
    public int Count
    {
        get
        {
            int head = Volatile.Read(ref _indices.Head);
            return Math.Min(Volatile.Read(ref _indices.Tail) - head, _slots.Count);
        }
    }

    // Producer. Returns false if the ring is full; the packet is then not stored, and the queued packets stay unchanged.
    public bool TryEnqueue(in ReceivedPacket packet)
    {
        int tail = _indices.Tail;
        if (tail - _indices.ProducersHead == _slots.Count)
        {
            _indices.ProducersHead = Volatile.Read(ref _indices.Head);
            if (tail - _indices.ProducersHead == _slots.Count)
                return false;
        }

        _slots.Store(tail & _mask, packet);
        Volatile.Write(ref _indices.Tail, tail + 1);
        return true;
    }

    // Consumer. The packet lies in its slot and is valid until Release.
    public bool TryPeek(out ReceivedPacket packet)
    {
        int head = _indices.Head;
        if (head == _indices.ConsumersTail)
        {
            _indices.ConsumersTail = Volatile.Read(ref _indices.Tail);
            if (head == _indices.ConsumersTail)
            {
                packet = default;
                return false;
            }
        }

        packet = _slots[head & _mask];
        return true;
    }

    // Number of packets that the consumer has finished with. Any thread.
    public long Released => Volatile.Read(ref _indices.Released);

    // Consumer, once after each successful TryPeek.
    public void Release()
    {
        Volatile.Write(ref _indices.Released, _indices.Released + 1);
        Volatile.Write(ref _indices.Head, _indices.Head + 1);
    }

    [StructLayout(LayoutKind.Explicit, Size = 384)]
    private struct Indices
    {
        [FieldOffset(128)]
        public int Tail;

        [FieldOffset(132)]
        public int ProducersHead;

        [FieldOffset(256)]
        public int Head;

        [FieldOffset(260)]
        public int ConsumersTail;

        [FieldOffset(264)]
        public long Released;
    }
}
