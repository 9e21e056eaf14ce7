using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Reusable memory for a fixed number of packets. One thread at a time uses a slot; other threads may use other slots at the same time.
internal sealed class PacketSlots(int count, int slotSize)
{
    // One block of memory: the slots are filled and read in order, so the processor can prefetch.
    private readonly byte[] _bytes = new byte[count * slotSize];
    private readonly Entry[] _entries = new Entry[count];

    public int Count => _entries.Length;

    // The bytes stay in place until the slot is filled again.
    public ReceivedPacket this[int slot]
    {
        get
        {
            ref Entry entry = ref _entries[slot];
            return entry.Length <= slotSize
                ? new ReceivedPacket(entry.Kind, _bytes, slot * slotSize, entry.Length, entry.Timestamp, entry.Origin)
                : new ReceivedPacket(entry.Kind, entry.Large!, 0, entry.Length, entry.Timestamp, entry.Origin);
        }
    }

    public void Store(int slot, in ReceivedPacket packet)
    {
        ref Entry entry = ref _entries[slot];
        entry.Kind = packet.Kind;
        entry.Length = packet.Length;
        entry.Timestamp = packet.Timestamp;
        entry.Origin = packet.Origin;
        if (packet.Length <= slotSize)
        {
            packet.Bytes.CopyTo(_bytes.AsSpan(slot * slotSize, slotSize));
            return;
        }

        if (entry.Large is null || entry.Large.Length < packet.Length)
            entry.Large = new byte[packet.Length];

        packet.Bytes.CopyTo(entry.Large);
    }

    // A packet larger than a slot gets its own memory, which is kept for later packets.
    private struct Entry
    {
        public PacketKind Kind;
        public int Length;
        public int Origin;
        public long Timestamp;
        public byte[]? Large;
    }
}
