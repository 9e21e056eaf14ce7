using System.Diagnostics.CodeAnalysis;
using System.Runtime.InteropServices;

namespace NeuronMocap.Recording;

// A bounded queue of bytes from the receive thread to the thread that writes a recording. It has one producer and one consumer, and needs
// neither locks nor allocation.
//
// Both indices count bytes without end and are taken modulo the capacity, a power of two. Only the producer writes the tail, and only the consumer
// writes the head. The producer fills in a whole record and then publishes the tail with a release. A consumer that sees the new tail with an
// acquire therefore sees the record. The consumer finishes a record before it publishes the head with a release. The producer overwrites those
// bytes only after it has seen the head with an acquire. The producers of one ring take turns, and hand over to each other with a lock or the end
// of a task.
//
// The indices are ints, so 32-bit processors read them atomically. The indices of the two sides are 128 bytes apart. The two cores then do not
// compete for a cache line, or for a pair of lines on processors that fetch pairs.
//
// Waking: a consumer that is about to wait sets a flag, executes a full fence, and checks the tail once more. A producer whose tail has entered another
// part of the ring executes a full fence and then checks the flag. At least one of the two therefore sees the other. A consumer waits only for less
// than a part, so the tail enters the next part before two parts wait.
[SuppressMessage("Design", "CA1001", Justification = "A producer may still signal after the consumer has ended.")]
internal sealed class PieceRing
{
    // Reserved for records of connections, which then find room even when no piece does.
    private const int Reserve = 16 * 1024;

    // The consumer is woken whenever a part of this size has been filled, so that at most two parts wait for it. It finds smaller amounts when its wait
    // times out. The fence before a look at its flag waits for the copy to reach the cache, and waking takes a system call.
    private const int WakeParts = 8;

    private readonly byte[] _bytes;
    private readonly int _mask;
    private readonly int _wakeLevel;
    private readonly AutoResetEvent _wake = new(initialState: false);
    private byte[] _joined = [];
    private Indices _indices;
    private int _isWaiting;

    // Tests start near the point where the indices wrap around.
    public PieceRing(int capacity, int firstIndex = 0)
    {
        int size = 2 * Reserve;
        while (size < capacity)
            size *= 2;

        _bytes = new byte[size];
        _mask = size - 1;
        _wakeLevel = size / WakeParts;
        _indices.Tail = _indices.ProducersHead = _indices.Head = _indices.ConsumersTail = firstIndex;
    }

    public int Capacity => _bytes.Length;

    // Producer. Whether there is room for a piece and its sender.
    public bool HasRoom(int length) => HasRoom(_bytes.Length - Reserve, PieceRecord.SizeOf(length));

    // Producer. Returns false if there is no room. In this case, nothing is stored, and queued records stay unchanged.
    public bool TryWrite(PieceRecord record, ReadOnlySpan<byte> text, ReadOnlySpan<byte> bytes)
    {
        record.TextLength = text.Length;
        record.Length = bytes.Length;
        if (!HasRoom(record.Kind == PieceKind.Bytes ? _bytes.Length - Reserve : _bytes.Length, record.Size))
            return false;

        int tail = _indices.Tail;
        int start = tail & _mask;
        if (start + record.Size <= _bytes.Length)
            PutWhole(_bytes.AsSpan(start, record.Size), record, text, bytes);
        else
            PutInParts(tail, record, text, bytes);

        Volatile.Write(ref _indices.Tail, tail + record.Size);

        // Without a look at the consumer's side, and without the fence, until another part is full.
        if (((tail ^ (tail + record.Size)) & -_wakeLevel) != 0)
            WakeWaiting();

        return true;
    }

    // Consumer. The record stays until Release.
    public bool TryPeek(out PieceRecord record)
    {
        record = default;
        int head = _indices.Head;
        if (head == _indices.ConsumersTail)
        {
            // Read only when everything known is used up, because each read takes the cache line away from the producer.
            _indices.ConsumersTail = Volatile.Read(ref _indices.Tail);
            if (head == _indices.ConsumersTail)
                return false;
        }

        Span<byte> header = stackalloc byte[PieceRecord.HeaderSize];
        Take(head, header);
        record = MemoryMarshal.Read<PieceRecord>(header);
        return true;
    }

    // Consumer. Returns the text and then the bytes of the record. They are valid until Release.
    public ReadOnlySpan<byte> Peek(in PieceRecord record)
    {
        int start = (_indices.Head + PieceRecord.HeaderSize) & _mask;
        int length = record.TextLength + record.Length;
        if (start + length <= _bytes.Length)
            return _bytes.AsSpan(start, length);

        if (_joined.Length < length)
            _joined = new byte[length];

        Take(start, _joined.AsSpan(0, length));
        return _joined.AsSpan(0, length);
    }

    // Consumer. Called once after each successful TryPeek.
    public void Release(in PieceRecord record) => Volatile.Write(ref _indices.Head, _indices.Head + record.Size);

    // Consumer. Waits until there are enough bytes, Wake is called, or the timeout expires.
    public void Wait(TimeSpan timeout)
    {
        Interlocked.Exchange(ref _isWaiting, 1);
        if (Volatile.Read(ref _indices.Tail) - _indices.Head < _wakeLevel)
            _wake.WaitOne(timeout);

        Volatile.Write(ref _isWaiting, 0);
    }

    // Any thread.
    public void Wake() => _wake.Set();

    private bool HasRoom(int capacity, int size)
    {
        if (_indices.Tail - _indices.ProducersHead <= capacity - size)
            return true;

        _indices.ProducersHead = Volatile.Read(ref _indices.Head);
        return _indices.Tail - _indices.ProducersHead <= capacity - size;
    }

    private void WakeWaiting()
    {
        Interlocked.MemoryBarrier();
        if (Volatile.Read(ref _isWaiting) != 0 && Interlocked.Exchange(ref _isWaiting, 0) != 0)
            _wake.Set();
    }

    private static void PutWhole(Span<byte> room, in PieceRecord record, ReadOnlySpan<byte> text, ReadOnlySpan<byte> bytes)
    {
        MemoryMarshal.Write(room, in record);
        room = room[PieceRecord.HeaderSize..];
        text.CopyTo(room);
        bytes.CopyTo(room[text.Length..]);
    }

    private void PutInParts(int index, in PieceRecord record, ReadOnlySpan<byte> text, ReadOnlySpan<byte> bytes)
    {
        Span<byte> header = stackalloc byte[PieceRecord.HeaderSize];
        MemoryMarshal.Write(header, in record);
        Put(index, header);
        Put(index + PieceRecord.HeaderSize, text);
        Put(index + PieceRecord.HeaderSize + text.Length, bytes);
    }

    private void Put(int index, ReadOnlySpan<byte> bytes)
    {
        int start = index & _mask;
        int first = Math.Min(bytes.Length, _bytes.Length - start);
        bytes[..first].CopyTo(_bytes.AsSpan(start));
        bytes[first..].CopyTo(_bytes);
    }

    private void Take(int index, Span<byte> destination)
    {
        int start = index & _mask;
        int first = Math.Min(destination.Length, _bytes.Length - start);
        _bytes.AsSpan(start, first).CopyTo(destination);
        _bytes.AsSpan(0, destination.Length - first).CopyTo(destination[first..]);
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

internal enum PieceKind
{
    // The text holds the end points of the connection.
    Opened,

    // The text is the sender's address in the system's format; the bytes are the piece.
    Bytes,

    // No text. The record holds the numbers of lost pieces and bytes.
    Lost,

    // The text is the reason.
    Closed,
}

// The header of each entry in the ring.
internal struct PieceRecord
{
    public const int HeaderSize = 48;

    private const int Alignment = 8;

    public PieceKind Kind;
    public int Connection;
    public int Sender;
    public int TextLength;
    public int Length;
    public bool IsDatagrams;
    public bool WasOpen;
    public bool IsCalculation;
    public long LostPieces;
    public long LostBytes;
    public long Timestamp;

    public readonly int Size => SizeOf(TextLength + Length);

    public static int SizeOf(int length) => (HeaderSize + length + Alignment - 1) & -Alignment;
}
