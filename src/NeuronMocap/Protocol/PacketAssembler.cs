namespace NeuronMocap.Protocol;

// Joins the pieces in which one sender's bytes arrive. Packets and lines that lie whole in a piece are read in place; only the unfinished tail
// of a piece is copied, and grows by no more than the scanner asked for until it is a packet or is known to be none. Not thread-safe.
// The tap, where there is one, is shown the pieces as they come.
internal sealed class PacketAssembler(PacketScanner scanner, IPacketReceiver receiver, StreamTap? tap = null)
{
    private const int InitialCapacity = 4096;

    private readonly StreamScanner _scanner = new(scanner);
    private byte[] _tail = [];
    private int _tailLength;
    private int _needed;

    // What the packets carry: PacketOrigin.
    public int Origin { get; set; }

    // Bytes that arrived and are not yet known to be a packet.
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

    // Whether a piece begins with a line of text of its own while the tail is an unfinished one. A tail of digits alone may be the start of the
    // piece's first number.
    public bool StartsAnew(ReadOnlySpan<byte> piece) => _scanner.IsInsideLine && TextLine.BeginsLine(piece);

    // Gives up the unfinished tail: what follows it is known to be missing.
    public void Abandon()
    {
        int length = _tailLength;
        _tailLength = 0;
        _scanner.Restart();
        if (length > 0)
            receiver.OnSkipped(_tail.AsSpan(0, length), SkipReason.Incomplete);
    }

    // For bytes that continue nothing, and begin something.
    public void BeginAnew() => _scanner.Begin();

    // For a sender that was heard too late to know whether its first bytes begin anything.
    public void JoinLate() => _scanner.Restart();

    // Returns what no packet was found in yet. What every packet passes from here on is inlined by hand where it is small: code that is
    // compiled ahead of time has no profile that tells.
    private ArraySegment<byte> Deliver(byte[] bytes, int offset, int count, long timestamp)
    {
        while (count > 0)
        {
            StreamScan scan = _scanner.Scan(bytes.AsSpan(offset, count));
            if (scan.Part == StreamPart.NeedMoreData)
            {
                _needed = scan.Length;
                break;
            }

            if (scan.Part == StreamPart.Packet)
                receiver.OnPacket(new ReceivedPacket(scan.Kind, bytes, offset, scan.Length, timestamp, Origin));
            else if (scan.Part == StreamPart.Skipped)
                receiver.OnSkipped(bytes.AsSpan(offset, scan.Length), scan.Reason);
            else
                DeliverText(scan, bytes.AsSpan(offset, scan.Length), timestamp);

            offset += scan.Length;
            count -= scan.Length;
        }

        return new ArraySegment<byte>(bytes, offset, count);
    }

    private void DeliverText(in StreamScan scan, ReadOnlySpan<byte> bytes, long timestamp)
    {
        receiver.OnText(bytes);
        if (scan.Part == StreamPart.Line)
            receiver.OnPacket(new ReceivedPacket(scan.Kind, _scanner.Image, 0, _scanner.ImageLength, timestamp, Origin));
    }

    // The rest may lie inside the tail itself; the copy handles the overlap.
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

    // For what has arrived, not for what a header announces: else 64 bytes of anybody's would take 100 KB here.
    private void Reserve(int length)
    {
        if (_tail.Length < length)
            Array.Resize(ref _tail, Math.Max(Math.Max(length, InitialCapacity), 2 * _tail.Length));
    }
}
