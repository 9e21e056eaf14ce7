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
    // One piece of memory, so that the processor, which sees it filled and read from one end to the other, fetches ahead.
    private readonly byte[] _bytes;
    private readonly Entry[] _entries;
    private readonly int _slotSize;
    private readonly int _mask;
    private Indices _indices;

    // Tests start next to where the indices wrap around.
    public PacketRing(int capacity, int slotSize, int firstIndex = 0)
    {
        int size = 1;
        while (size < capacity)
            size *= 2;

        _mask = size - 1;
        _slotSize = slotSize;
        _bytes = new byte[size * slotSize];
        _entries = new Entry[size];
        _indices.Tail = _indices.ProducersHead = _indices.Head = _indices.ConsumersTail = firstIndex;
    }

    public int Capacity => _entries.Length;

    // Any thread; exact only when both sides are still. The head first: it never overtakes a tail that is read after it.
    public int Count
    {
        get
        {
            int head = Volatile.Read(ref _indices.Head);
            return Math.Min(Volatile.Read(ref _indices.Tail) - head, _entries.Length);
        }
    }

    // Producer. False when full: the packet is not stored, and nothing that is queued is touched.
    public bool TryEnqueue(in ReceivedPacket packet)
    {
        int tail = _indices.Tail;
        if (tail - _indices.ProducersHead == _entries.Length)
        {
            _indices.ProducersHead = Volatile.Read(ref _indices.Head);
            if (tail - _indices.ProducersHead == _entries.Length)
                return false;
        }

        Store(tail & _mask, packet);
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

        packet = Load(head & _mask);
        return true;
    }

    // Consumer, once after each successful TryPeek.
    public void Release() => Volatile.Write(ref _indices.Head, _indices.Head + 1);

    private void Store(int slot, in ReceivedPacket packet)
    {
        ref Entry entry = ref _entries[slot];
        entry.Kind = packet.Kind;
        entry.Length = packet.Length;
        entry.Timestamp = packet.Timestamp;
        entry.Origin = packet.Origin;
        if (packet.Length <= _slotSize)
        {
            packet.Bytes.CopyTo(_bytes.AsSpan(slot * _slotSize, _slotSize));
            return;
        }

        if (entry.Large is null || entry.Large.Length < packet.Length)
            entry.Large = new byte[packet.Length];

        packet.Bytes.CopyTo(entry.Large);
    }

    private ReceivedPacket Load(int slot)
    {
        ref Entry entry = ref _entries[slot];
        return entry.Length <= _slotSize
            ? new ReceivedPacket(entry.Kind, _bytes, slot * _slotSize, entry.Length, entry.Timestamp, entry.Origin)
            : new ReceivedPacket(entry.Kind, entry.Large!, 0, entry.Length, entry.Timestamp, entry.Origin);
    }

    // What a slot holds. A packet that is larger than a slot lies in memory of its own, which stays for the next one.
    private struct Entry
    {
        public PacketKind Kind;
        public int Length;
        public int Origin;
        public long Timestamp;
        public byte[]? Large;
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
    }
}
