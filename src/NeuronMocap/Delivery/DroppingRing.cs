using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// A bounded queue that makes room by dropping its oldest packet, between one producer (the receive thread) and one consumer, without locks or allocations.
//
// A place holds the index of a packet, the slot with its bytes, and whether it is waiting, in one number. The place of an index is the index modulo the
// capacity, a power of two. There is one slot more than there are places.
//
// Each slot has one owner. The slot of a waiting place belongs to the ring. The only way to get it is to change the place from waiting to empty with a
// compare-exchange, so the consumer (to read it) and the producer (to drop it) cannot both succeed. The consumer leaves its spare slot in the place and
// keeps the other one, until it takes the next packet. That slot is then in no place, and the producer fills only slots that it finds in places. The
// producer therefore never overwrites a packet that is being read. The slot of an empty place belongs to the producer, who alone changes empty places.
//
// The producer fills a slot before it publishes the place, and the consumer reads the slot after its compare-exchange. The consumer has read its spare slot
// before the compare-exchange that gives it away, and the producer reads the place before it fills the slot. Each pair is ordered by a release and an
// acquire, or by a full fence. A place cannot return to an old number unless 2^32 packets pass between two steps of the consumer.
internal sealed class DroppingRing
{
    private const int SlotShift = 1;
    private const int IndexShift = 32;
    private const long SlotMask = 0x7FFF_FFFF;
    private const long Waiting = 1;

    private readonly PacketSlots _slots;
    private readonly long[] _places;
    private readonly int _mask;
    private int _tail; // The next index of the producer.
    private int _head; // The next index of the consumer, unless it was dropped.
    private int _spare; // The consumer's slot.
    private long _stored;
    private long _dropped;
    private long _taken;

    // Tests start close to the wrap-around of the indices.
    public DroppingRing(int capacity, int slotSize, int firstIndex = 0)
    {
        int size = 1;
        while (size < capacity)
            size *= 2;

        _mask = size - 1;
        _slots = new PacketSlots(size + 1, slotSize);
        _places = new long[size];
        _tail = _head = firstIndex;
        _spare = size;
        for (int i = 0; i < size; i++)
            _places[(firstIndex + i) & _mask] = Place(firstIndex + i - size, slot: i, isWaiting: false);
    }

    public int Capacity => _places.Length;

    // Number of packets that were dropped to make room. Any thread.
    public long Dropped => Volatile.Read(ref _dropped);

    // Number of packets that the consumer has taken. Any thread.
    public long Taken => Volatile.Read(ref _taken);

    // Any thread; exact only while both sides are idle. Reads what left before what arrived, so the result is never negative.
    public int Count
    {
        get
        {
            long left = Taken + Dropped;
            return (int)Math.Min(Volatile.Read(ref _stored) - left, _places.Length);
        }
    }

    // Producer.
    public void Store(in ReceivedPacket packet)
    {
        int tail = _tail;
        ref long shared = ref _places[tail & _mask];
        long place = Volatile.Read(ref shared);
        if ((place & Waiting) != 0)
        {
            long found = Interlocked.CompareExchange(ref shared, place & ~Waiting, place);
            if (found == place)
                Volatile.Write(ref _dropped, _dropped + 1);
            else
                place = found;
        }

        int slot = SlotOf(place);
        _slots.Store(slot, packet);
        _tail = tail + 1;
        Volatile.Write(ref _stored, _stored + 1);
        Volatile.Write(ref shared, Place(tail, slot, isWaiting: true));
    }

    // Consumer. The packet lies in the consumer's slot and is valid until the next call.
    public bool TryTake(out ReceivedPacket packet)
    {
        while (true)
        {
            ref long shared = ref _places[_head & _mask];
            long place = Volatile.Read(ref shared);
            int ahead = IndexOf(place) - _head;
            if (ahead < 0)
            {
                packet = default;
                return false;
            }

            // The producer has dropped this packet, and perhaps stored another one in its place. All packets before that one were dropped, too, but for
            // those after the dropped one, which wait.
            if (ahead > 0 || (place & Waiting) == 0)
            {
                _head = ahead > 0 ? IndexOf(place) - _mask : _head + 1;
                continue;
            }

            long given = Place(_head, _spare, isWaiting: false);
            if (Interlocked.CompareExchange(ref shared, given, place) != place)
                continue;

            _spare = SlotOf(place);
            _head++;
            Volatile.Write(ref _taken, _taken + 1);
            packet = _slots[_spare];
            return true;
        }
    }

    private static long Place(int index, int slot, bool isWaiting) =>
        ((long)index << IndexShift) | ((long)slot << SlotShift) | (isWaiting ? Waiting : 0);

    private static int IndexOf(long place) => (int)(place >> IndexShift);

    private static int SlotOf(long place) => (int)((place & SlotMask) >> SlotShift);
}
