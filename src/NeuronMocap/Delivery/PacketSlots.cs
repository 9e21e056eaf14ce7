using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Memory for a fixed number of packets, used again and again. One thread at a time uses a slot; others may use other slots meanwhile.
internal sealed class PacketSlots(int count, int slotSize)
{
    // One piece of memory: where slots are filled and read one after the other, the processor fetches ahead.
    private readonly byte[] _bytes = new byte[count * slotSize];
    private readonly Entry[] _entries = new Entry[count];

    public int Count => _entries.Length;

    // The bytes stay where they are until the slot is filled again.
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

    // A packet that is larger than a slot lies in memory of its own, which stays for the next one.
    private struct Entry
    {
        public PacketKind Kind;
        public int Length;
        public int Origin;
        public long Timestamp;
        public byte[]? Large;
    }
}
