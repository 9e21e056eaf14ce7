namespace NeuronMocap.Recording;

// Decodes the entries of one block, one after the other.
internal sealed class EntryDecoder
{
    private byte[] _payload = [];
    private int _start;
    private int _end;
    private long _time;
    private int _connection;
    private int _sender;
    private int _pieceLength;

    // Number of remaining bytes in the block.
    public int Remaining => _end - _start;

    public void Begin(ArraySegment<byte> payload, long time)
    {
        _payload = payload.Array!;
        _start = payload.Offset;
        _end = payload.Offset + payload.Count;
        _time = time;
        _connection = -1;
        _sender = -1;
        _pieceLength = -1;
    }

    public void End() => _start = _end;

    // Returns false at the end of the block, or at data that no writer produces. In the second case, bytes remain.
    public bool TryTake(out RecordingEntry entry)
    {
        // An entry kind of a later minor version is skipped.
        bool isKnown;
        do
        {
            isKnown = true;
            var cursor = new ByteCursor(_payload.AsSpan(_start, _end - _start));
            if (!TryTake(ref cursor, out entry, ref isKnown))
                return false;

            _start = _end - cursor.Rest.Length;
        }
        while (!isKnown);

        return true;
    }

    private bool TryTake(scoped ref ByteCursor cursor, out RecordingEntry entry, scoped ref bool isKnown)
    {
        entry = default;
        if (!cursor.TryTake(1, out ReadOnlySpan<byte> tag) || !cursor.TryTakeNumber(out long delta) || delta > RecordingLayout.MaxTime - _time)
            return false;

        long time = _time + delta;
        bool isTaken = (tag[0] & EntryEncoder.BytesTag) != 0
            ? TryTakeBytes(ref cursor, tag[0], time, out entry)
            : cursor.TryTakeNumber(out int length) && cursor.TryTake(length, out ReadOnlySpan<byte> body)
                && TryTakeBody(new ByteCursor(body), (RecordingEntryKind)tag[0], time, out entry, out isKnown);
        if (isTaken)
            _time = time;

        return isTaken;
    }

    private bool TryTakeBytes(scoped ref ByteCursor cursor, byte tag, long time, out RecordingEntry entry)
    {
        entry = default;
        (int connection, int sender, int length) = (_connection, _sender, _pieceLength);
        if ((tag & EntryEncoder.SameSenderFlag) == 0 && (!cursor.TryTakeNumber(out connection) || !cursor.TryTakeNumber(out sender)))
            return false;
        if ((tag & EntryEncoder.SameLengthFlag) == 0 && !cursor.TryTakeNumber(out length))
            return false;
        if (connection < 0 || !cursor.TryTake(length, out ReadOnlySpan<byte> bytes))
            return false;

        (_connection, _sender, _pieceLength) = (connection, sender, length);
        entry = new RecordingEntry { Time = new TimeSpan(time), Connection = connection, Sender = sender, Bytes = bytes };
        return true;
    }

    private static bool TryTakeBody(ByteCursor body, RecordingEntryKind kind, long time, out RecordingEntry entry, out bool isKnown)
    {
        isKnown = kind is >= RecordingEntryKind.ConnectionOpened and <= RecordingEntryKind.Metadata;
        entry = default;
        if (!isKnown)
            return true;

        int connection = 0;
        if (kind != RecordingEntryKind.Metadata && !body.TryTakeNumber(out connection))
            return false;

        var common = new RecordingEntry { Kind = kind, Time = new TimeSpan(time), Connection = connection };
        switch (kind)
        {
            case RecordingEntryKind.ConnectionOpened:
                if (!TryTakeConnection(ref body, connection, out RecordedConnection? opened))
                    return false;

                entry = common with { Opened = opened };
                return true;
            case RecordingEntryKind.SenderAdded:
            case RecordingEntryKind.SenderRemoved:
                if (!body.TryTakeNumber(out int sender))
                    return false;

                entry = common with { Sender = sender, Text = kind == RecordingEntryKind.SenderAdded ? body.TakeRestAsText() : null };
                return true;
            case RecordingEntryKind.BytesLost:
                if (!body.TryTakeNumber(out long pieces) || !body.TryTakeNumber(out long bytes))
                    return false;

                entry = common with { LostPieces = pieces, LostBytes = bytes };
                return true;
            case RecordingEntryKind.Metadata:
                if (!body.TryTakeText(out string key))
                    return false;

                entry = common with { Key = key, Text = body.TakeRestAsText() };
                return true;
            default:
                entry = common with { Text = body.TakeRestAsText() };
                return true;
        }
    }

    private static bool TryTakeConnection(scoped ref ByteCursor body, int number, out RecordedConnection? connection)
    {
        connection = null;
        if (!body.TryTake(2, out ReadOnlySpan<byte> kind) || kind[0] > (byte)TransportKind.Udp
            || !body.TryTakeText(out string local) || !body.TryTakeText(out string remote))
        {
            return false;
        }

        connection = new RecordedConnection(number, (TransportKind)kind[0], local, remote)
        {
            WasOpen = (kind[1] & EntryEncoder.WasOpenFlag) != 0,
            IsCalculation = (kind[1] & EntryEncoder.CalculationFlag) != 0,
        };
        return true;
    }
}
