using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// A bounded queue between one producer (the receive thread) and one consumer (the application's), without locks or allocation.
//
// Both indices count up without end and are taken modulo the capacity, a power of two. The producer alone writes the tail, the consumer
// alone writes the head. The producer fills a slot and then publishes the tail with a release; the consumer that sees the new tail with an
// acquire therefore sees the filled slot. The consumer is done with a slot before it publishes the head with a release, and the producer
// fills that slot only after it has seen the head with an acquire. Each side keeps a copy of the other's index and looks again only when
// the copy says full or empty. The indices are ints, so that they are read whole on 32-bit processors, and each side's lie 128 bytes from
// the other's, so that the two cores do not fight over a cache line (or over a pair of them, where the processor fetches pairs).
internal sealed class PacketRing
{
    private readonly PacketSlots _slots;
    private readonly int _mask;
    private Indices _indices;

    // Tests start next to where the indices wrap around.
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

    // Any thread; exact only when both sides are still. The head first: it never overtakes a tail that is read after it.
    public int Count
    {
        get
        {
            int head = Volatile.Read(ref _indices.Head);
            return Math.Min(Volatile.Read(ref _indices.Tail) - head, _slots.Count);
        }
    }

    // Producer. False when full: the packet is not stored, and nothing that is queued is touched.
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

    // Packets that the consumer was done with so far. Any thread.
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
