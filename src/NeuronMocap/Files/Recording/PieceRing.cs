using System.Diagnostics.CodeAnalysis;
using System.Runtime.InteropServices;

namespace NeuronMocap.Recording;

// What goes from the receive thread to the thread that writes a recording: a bounded queue of bytes between one producer and one consumer,
// without locks or allocation.
//
// Both indices count bytes up without end and are taken modulo the capacity, a power of two. The producer alone writes the tail, the consumer alone
// writes the head. The producer fills in a whole record and then publishes the tail with a release; the consumer that sees the new tail with an
// acquire therefore sees the record. The consumer is done with a record before it publishes the head with a release, and the producer overwrites
// those bytes only after it has seen the head with an acquire. The producers of one ring take turns, and hand over to each other with a lock or the
// end of a task. The indices are ints, so that they are read whole on 32-bit processors, and each side's lie 128 bytes from the other's, so that
// the two cores do not fight over a cache line (or over a pair of them, where the processor fetches pairs).
//
// Waking: a consumer that is about to wait says so, with a full fence behind it, and then looks at the tail once more; a producer that has published
// the tail puts a full fence behind it before it looks whether the consumer waits. One of the two therefore sees the other.
[SuppressMessage("Design", "CA1001", Justification = "A producer may still signal when the consumer is gone.")]
internal sealed class PieceRing
{
    // Records of connections find room even when no piece does.
    private const int Reserve = 16 * 1024;

    // As many bytes are worth waking the consumer for. What is less waits until it looks by itself.
    private const int WakeLevel = 64 * 1024;

    private readonly byte[] _bytes;
    private readonly int _mask;
    private readonly AutoResetEvent _wake = new(initialState: false);
    private byte[] _joined = [];
    private Indices _indices;
    private int _isWaiting;

    // Tests start next to where the indices wrap around.
    public PieceRing(int capacity, int firstIndex = 0)
    {
        int size = 2 * Reserve;
        while (size < capacity)
            size *= 2;

        _bytes = new byte[size];
        _mask = size - 1;
        _indices.Tail = _indices.ProducersHead = _indices.Head = firstIndex;
    }

    public int Capacity => _bytes.Length;

    // Producer: for a piece, with its sender.
    public bool HasRoom(int length) => HasRoom(_bytes.Length - Reserve, PieceRecord.SizeOf(length));

    // Producer. False when there is no room: nothing is stored, and nothing that is queued is touched.
    public bool TryWrite(PieceRecord record, ReadOnlySpan<byte> text, ReadOnlySpan<byte> bytes)
    {
        record.TextLength = text.Length;
        record.Length = bytes.Length;
        if (!HasRoom(record.Kind == PieceKind.Bytes ? _bytes.Length - Reserve : _bytes.Length, record.Size))
            return false;

        int tail = _indices.Tail;
        Put(tail, MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref record, 1)));
        Put(tail + PieceRecord.HeaderSize, text);
        Put(tail + PieceRecord.HeaderSize + text.Length, bytes);
        Volatile.Write(ref _indices.Tail, tail + record.Size);

        // A head that is older than this only wakes the consumer too early.
        if (tail + record.Size - _indices.ProducersHead >= WakeLevel)
            WakeWaiting();

        return true;
    }

    // Consumer. The record stays until Release.
    public bool TryPeek(out PieceRecord record)
    {
        record = default;
        int head = _indices.Head;
        if (head == Volatile.Read(ref _indices.Tail))
            return false;

        Take(head, MemoryMarshal.AsBytes(MemoryMarshal.CreateSpan(ref record, 1)));
        return true;
    }

    // Consumer: text and bytes of the record, one after the other, until Release.
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

    // Consumer, once after each successful TryPeek.
    public void Release(in PieceRecord record) => Volatile.Write(ref _indices.Head, _indices.Head + record.Size);

    // Consumer: until there is something worth it, Wake is called, or the time is over.
    public void Wait(TimeSpan timeout)
    {
        Interlocked.Exchange(ref _isWaiting, 1);
        if (Volatile.Read(ref _indices.Tail) - _indices.Head < WakeLevel)
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
    }
}

internal enum PieceKind
{
    // The text is the end points of the connection.
    Opened,

    // The text is the sender's address as the system writes it; the bytes are the piece.
    Bytes,

    // No text; what was lost stands in the record.
    Lost,

    // The text is the reason.
    Closed,
}

// In front of each entry of the ring.
internal struct PieceRecord
{
    public const int HeaderSize = 48;

    private const int Alignment = 8;

    public PieceKind Kind;
    public int Connection;
    public int Source;
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
