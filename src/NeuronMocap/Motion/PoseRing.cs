using System.Runtime.InteropServices;

namespace NeuronMocap.Motion;

// Slots that go round between one writing and one sampling thread. The writer fills the slot at Head and publishes it by storing Head + 1
// with release semantics; the sampler reads Head with acquire semantics, so it sees all that was written to the slots before. The
// same holds backwards for Tail. Each stands on cache lines of its own, so that a thread that stores one does not slow down the other. Between the two the slots are the sampler's own, in any order and for as long as it likes: neither
// ever waits, and nothing is read while it is written.
internal sealed class PoseRing
{
    private readonly PoseSlot[] _slots;
    private readonly int _mask;

    private Numbers _numbers;

    // Tests start next to where the numbers wrap around.
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

    // The writer's: the next slot, or null while all are in use.
    public PoseSlot? Free => _numbers.Head - Volatile.Read(ref _numbers.Tail) < _slots.Length ? At(_numbers.Head) : null;

    // The writer's: hands over the slot that it has filled.
    public void Publish() => Volatile.Write(ref _numbers.Head, _numbers.Head + 1);

    // The sampler's: number of the slot after the newest one. Numbers count on and may wrap; compare them by their difference.
    public int End => Volatile.Read(ref _numbers.Head);

    public PoseSlot At(int number) => _slots[number & _mask];

    // The sampler's: gives back all slots from the oldest on that are done, of those before a number.
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
