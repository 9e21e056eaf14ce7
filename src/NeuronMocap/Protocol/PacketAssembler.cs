namespace NeuronMocap.Protocol;

// Joins the pieces in which one sender's bytes arrive. Packets that lie whole in a piece are handed over in place; only the unfinished tail
// of a piece is copied, and grows by no more than the scanner asked for until it is a packet or is known to be none. Not thread-safe.
internal sealed class PacketAssembler(PacketScanner scanner, IPacketReceiver receiver, int source = 0)
{
    private const int InitialCapacity = 4096;

    private byte[] _tail = [];
    private int _tailLength;
    private int _needed;

    public int Source => source;

    // Bytes that arrived and are not yet known to be a packet.
    public int PendingBytes => _tailLength;

    public void Push(ArraySegment<byte> piece, long timestamp)
    {
        while (_tailLength > 0 && piece.Count > 0)
        {
            int taken = Math.Min(_needed - _tailLength, piece.Count);
            Append(piece.Slice(0, taken));
            piece = piece.Slice(taken);
            if (_tailLength < _needed)
                return;

            KeepTail(Deliver(_tail, 0, _tailLength, timestamp));
        }

        if (piece.Count > 0)
            KeepTail(Deliver(piece.Array!, piece.Offset, piece.Count, timestamp));
    }

    // Gives up the unfinished tail: what follows it is known to be missing.
    public void Abandon()
    {
        if (_tailLength == 0)
            return;

        int length = _tailLength;
        _tailLength = 0;
        receiver.OnSkipped(_tail.AsSpan(0, length), SkipReason.Incomplete);
    }

    // Returns what no packet was found in yet.
    private ArraySegment<byte> Deliver(byte[] bytes, int offset, int count, long timestamp)
    {
        while (count > 0)
        {
            ScanResult result = scanner.Scan(bytes.AsSpan(offset, count));
            if (result.Status == ScanStatus.NeedMore)
            {
                _needed = result.Length;
                break;
            }

            if (result.Status == ScanStatus.Packet)
                receiver.OnPacket(new ReceivedPacket(result.Kind, bytes, offset, result.Length, timestamp, source));
            else
                receiver.OnSkipped(bytes.AsSpan(offset, result.Length), result.Reason);

            offset += result.Length;
            count -= result.Length;
        }

        return new ArraySegment<byte>(bytes, offset, count);
    }

    // The rest may lie inside the tail itself; the copy handles the overlap.
    private void KeepTail(ArraySegment<byte> rest)
    {
        if (rest.Count > 0)
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
