using System.Runtime.CompilerServices;

namespace NeuronMocap.Protocol;

// Joins the pieces in which one sender's bytes arrive. Packets and lines that lie completely in a piece are read in place. Only the unfinished tail of a
// piece is copied. The tail grows by the number of bytes that the scanner asks for, until it is a packet or is known not to be one. The tap, if any, gets
// each piece as received. Not thread-safe.
internal sealed class PacketAssembler(PacketScanner scanner, IPacketReceiver receiver, StreamTap? tap = null)
{
    private const int InitialCapacity = 4096;

    private readonly StreamScanner _scanner = new(scanner);
    private byte[] _tail = [];
    private int _tailLength;
    private int _needed;

    // The PacketOrigin of the packets.
    public int Origin { get; set; }

    // Number of received bytes that are not yet known to be a packet.
    public int PendingBytes => _tailLength;

    public void Push(ArraySegment<byte> piece, long timestamp)
    {
        tap?.OnBytes(0, [], piece, timestamp);
        while (_tailLength > 0 && piece.Count > 0)
        {
            int taken = _scanner.Wanted(piece, _tailLength, _needed);
            Append(piece.Slice(0, taken));
            piece = piece.Slice(taken);
            if (_tailLength < _needed)
                return;

            KeepTail(Deliver(_tail, 0, _tailLength, timestamp));
        }

        if (piece.Count > 0)
            KeepTail(Deliver(piece.Array!, piece.Offset, piece.Count, timestamp));
    }

    // Whether a piece begins with its own line of text while the tail is an unfinished line. A tail that consists only of digits may be the start of the
    // piece's first number.
    public bool StartsAnew(ReadOnlySpan<byte> piece) => _scanner.IsInsideLine && TextLine.BeginsLine(piece);

    // Drops the unfinished tail, because the bytes after it are known to be missing.
    public void Abandon()
    {
        int length = _tailLength;
        _tailLength = 0;
        _scanner.Restart();
        if (length > 0)
            receiver.OnSkipped(_tail.AsSpan(0, length), SkipReason.Incomplete);
    }

    // Called if the next bytes do not continue the earlier ones, and begin a packet or a line.
    public void BeginAnew() => _scanner.Begin();

    // Called for a sender that was heard too late to know whether its first bytes begin a packet or a line.
    public void JoinLate() => _scanner.Restart();

    // Returns the bytes in which no packet was found yet. Small methods on the path of every packet are inlined by attribute, because code that is
    // compiled ahead of time has no profile. This method stays on its own. As a part of a larger one, it exceeds what the compiler inlines into one method,
    // and the small methods are called.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private ArraySegment<byte> Deliver(byte[] bytes, int offset, int count, long timestamp)
    {
        while (count > 0)
        {
            int length = _scanner.TakeMotion(bytes.AsSpan(offset, count));
            if (length > 0)
                receiver.OnPacket(new ReceivedPacket(PacketKind.Motion, bytes, offset, length, timestamp, Origin));
            else if ((length = DeliverOther(bytes, offset, count, timestamp)) == 0)
                break;

            offset += length;
            count -= length;
        }

        return new ArraySegment<byte>(bytes, offset, count);
    }

    // Returns the length of the part at the start, or 0 if it is incomplete.
    private int DeliverOther(byte[] bytes, int offset, int count, long timestamp)
    {
        StreamScan scan = _scanner.Scan(bytes.AsSpan(offset, count));
        if (scan.Part == StreamPart.NeedMoreData)
        {
            _needed = scan.Length;
            return 0;
        }

        if (scan.Part == StreamPart.Packet)
            receiver.OnPacket(new ReceivedPacket(scan.Kind, bytes, offset, scan.Length, timestamp, Origin));
        else if (scan.Part == StreamPart.Skipped)
            receiver.OnSkipped(bytes.AsSpan(offset, scan.Length), scan.Reason);
        else
            DeliverText(scan, bytes.AsSpan(offset, scan.Length), timestamp);

        return scan.Length;
    }

    private void DeliverText(in StreamScan scan, ReadOnlySpan<byte> bytes, long timestamp)
    {
        receiver.OnText(bytes, scan.Part == StreamPart.Line ? scan.Kind : PacketKind.None);
        if (scan.Part == StreamPart.Line)
            receiver.OnPacket(new ReceivedPacket(scan.Kind, _scanner.Image, 0, _scanner.ImageLength, timestamp, Origin));
    }

    // The rest may lie inside the tail itself; BlockCopy handles the overlap.
    private void KeepTail(ArraySegment<byte> rest)
    {
        if (rest.Count > 0 && (rest.Array != _tail || rest.Offset > 0))
        {
            Reserve(rest.Count);
            Buffer.BlockCopy(rest.Array!, rest.Offset, _tail, 0, rest.Count);
        }

        _tailLength = rest.Count;
    }

    private void Append(ArraySegment<byte> bytes)
    {
        Reserve(_tailLength + bytes.Count);
        Buffer.BlockCopy(bytes.Array!, bytes.Offset, _tail, _tailLength, bytes.Count);
        _tailLength += bytes.Count;
    }

    // Reserves memory for received bytes, not for the size in a header. Otherwise 64 bytes from any sender would allocate 100 KB.
    private void Reserve(int length)
    {
        if (_tail.Length < length)
            Array.Resize(ref _tail, Math.Max(Math.Max(length, InitialCapacity), 2 * _tail.Length));
    }
}
