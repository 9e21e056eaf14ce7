using System.Runtime.InteropServices;

namespace NeuronMocap.Motion;

// A ring of slots between one writing and one sampling thread. Neither thread waits, and no slot is read while it is written.
//
// The writer fills the slot at Head and publishes it by storing Head + 1 with release semantics. The sampler reads Head with acquire semantics, and
// therefore sees all data written to the slots before. The same holds in the other direction for Tail. Head and Tail are on separate cache lines; a
// store by one thread does not slow down the other. The slots between Tail and Head belong to the sampler, which may use them in any order and for
// any time.
internal sealed class PoseRing
{
    private readonly PoseSlot[] _slots;
    private readonly int _mask;

    private Numbers _numbers;

    // Tests start near the point where the numbers wrap around.
    public PoseRing(int capacity, int firstNumber = 0)
    {
        int size = 1;
        while (size < capacity)
            size *= 2;

        _slots = [.. Enumerable.Range(0, size).Select(static _ => new PoseSlot())];
        _mask = size - 1;
        _numbers.Head = _numbers.Tail = firstNumber;
    }

    public int Capacity => _slots.Length;

    // Writer. The next slot, or null while all are in use.
    public PoseSlot? Free => _numbers.Head - Volatile.Read(ref _numbers.Tail) < _slots.Length ? At(_numbers.Head) : null;

    // Writer. Publishes the slot that it has filled.
    public void Publish() => Volatile.Write(ref _numbers.Head, _numbers.Head + 1);

    // Sampler. Number of the slot after the newest one. Numbers may wrap around; compare them by their difference.
    public int End => Volatile.Read(ref _numbers.Head);

    public PoseSlot At(int number) => _slots[number & _mask];

    // Sampler. Releases the oldest slots that are done, up to a number.
    public void Release(int end)
    {
        int tail = _numbers.Tail;
        while (tail != end && At(tail).IsDone)
            tail++;

        Volatile.Write(ref _numbers.Tail, tail);
    }

    [StructLayout(LayoutKind.Explicit, Size = 384)]
    private struct Numbers
    {
        [FieldOffset(128)]
        public int Head;

        [FieldOffset(256)]
        public int Tail;
    }
}
