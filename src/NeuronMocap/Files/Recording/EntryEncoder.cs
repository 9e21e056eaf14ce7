namespace NeuronMocap.Recording;

// Encodes the entries of one block, after space reserved for the block header. Times and repeated values are stored as differences within the
// block. Each block can therefore be read independently. A piece that follows another one costs four bytes, or six if its length differs.
internal sealed class EntryEncoder
{
    public const byte BytesTag = 0x80;
    public const byte SameSenderFlag = 0x01;
    public const byte SameLengthFlag = 0x02;

    // Flags of a connection.
    public const byte WasOpenFlag = 0x01;
    public const byte CalculationFlag = 0x02;

    private readonly ByteBuffer _block = new(RecordingLayout.BlockHeaderSize + RecordingLayout.BlockSize + 4096);
    private readonly ByteBuffer _body = new(256);
    private long _time;
    private int _connection;
    private int _sender;
    private int _pieceLength;

    public EntryEncoder() => Clear();

    public bool IsEmpty => Length == 0;

    // Length of the payload.
    public int Length => _block.Length - RecordingLayout.BlockHeaderSize;

    public long FirstTime { get; private set; }

    // The header, which is filled in later, and the payload.
    public Span<byte> Block => _block.Array.AsSpan(0, _block.Length);

    public void Clear()
    {
        _block.Length = RecordingLayout.BlockHeaderSize;
        _connection = -1;
        _sender = -1;
        _pieceLength = -1;
    }

    public void AddBytes(long time, int connection, int sender, ReadOnlySpan<byte> bytes)
    {
        bool isSameSender = connection == _connection && sender == _sender;
        bool isSameLength = bytes.Length == _pieceLength;
        Begin((byte)(BytesTag | (isSameSender ? SameSenderFlag : 0) | (isSameLength ? SameLengthFlag : 0)), time);
        if (!isSameSender)
        {
            _block.AppendNumber(connection);
            _block.AppendNumber(sender);
        }

        if (!isSameLength)
            _block.AppendNumber(bytes.Length);

        _block.Append(bytes);
        (_connection, _sender, _pieceLength) = (connection, sender, bytes.Length);
    }

    public void AddOpened(long time, RecordedConnection connection)
    {
        _body.AppendNumber(connection.Number);
        _body.Append((byte)connection.Transport);
        _body.Append((byte)((connection.WasOpen ? WasOpenFlag : 0) | (connection.IsCalculation ? CalculationFlag : 0)));
        _body.AppendText(connection.Local, withLength: true);
        _body.AppendText(connection.Remote, withLength: true);
        AddBody(RecordingEntryKind.ConnectionOpened, time);
    }

    public void AddSender(long time, int connection, int sender, string address)
    {
        _body.AppendNumber(connection);
        _body.AppendNumber(sender);
        _body.AppendText(address, withLength: false);
        AddBody(RecordingEntryKind.SenderAdded, time);
    }

    public void AddSenderRemoved(long time, int connection, int sender)
    {
        _body.AppendNumber(connection);
        _body.AppendNumber(sender);
        AddBody(RecordingEntryKind.SenderRemoved, time);
    }

    public void AddClosed(long time, int connection, string reason)
    {
        _body.AppendNumber(connection);
        _body.AppendText(reason, withLength: false);
        AddBody(RecordingEntryKind.ConnectionClosed, time);
    }

    public void AddLoss(long time, int connection, long pieces, long bytes)
    {
        _body.AppendNumber(connection);
        _body.AppendNumber(pieces);
        _body.AppendNumber(bytes);
        AddBody(RecordingEntryKind.BytesLost, time);
    }

    public void AddMetadata(long time, string key, string value)
    {
        _body.AppendText(key, withLength: true);
        _body.AppendText(value, withLength: false);
        AddBody(RecordingEntryKind.Metadata, time);
    }

    private void AddBody(RecordingEntryKind kind, long time)
    {
        Begin((byte)kind, time);
        _block.AppendNumber(_body.Length);
        _block.Append(_body.Written);
        _body.Length = 0;
    }

    private void Begin(byte tag, long time)
    {
        if (IsEmpty)
            FirstTime = _time = time;

        _block.Append(tag);
        _block.AppendNumber(time - _time);
        _time = time;
    }
}
