namespace NeuronMocap.Recording;

// Writes the file header and then block by block. One write contains header and payload of a block, so a killed process leaves whole blocks. After
// a failure of the stream, nothing more is written, and an incomplete block is cut off.
internal sealed class BlockWriter : IDisposable
{
    private readonly Stream _stream;
    private readonly uint _seed;
    private readonly long _start;
    private readonly BlockCompression _compression = new();
    private uint _sequence;
    private bool _hasFailed;

    public BlockWriter(Stream stream, RecordingHeader header, bool compress, bool leaveOpen)
    {
        _stream = stream;
        _start = stream.CanSeek ? stream.Position : 0;
        Compress = compress;
        LeaveOpen = leaveOpen;
        byte[] head = new byte[RecordingLayout.FileHeaderSize];
        _seed = header.Write(head);
        Write(head);
    }

    public bool Compress { get; }

    public bool LeaveOpen { get; }

    public bool HasFailed => _hasFailed;

    // Number of bytes that the stream has accepted.
    public long Length { get; private set; }

    // Writes the entries and clears the encoder.
    public void Write(BlockKind kind, EntryEncoder entries, long time)
    {
        Span<byte> block = entries.Block;
        try
        {
            if (Compress && _compression.TryPack(block[RecordingLayout.BlockHeaderSize..], out Span<byte> packed))
                Write(kind, BlockEncoding.Deflate, time, packed);
            else
                Write(kind, BlockEncoding.Plain, time, block);
        }
        finally
        {
            entries.Clear();
        }
    }

    // The buffer begins with space reserved for a block header.
    public void Write(BlockKind kind, ByteBuffer block, long time) => Write(kind, BlockEncoding.Plain, time, block.Array.AsSpan(0, block.Length));

    public void Flush()
    {
        if (!_hasFailed)
            _stream.Flush();
    }

    public void Dispose()
    {
        _compression.Dispose();
        if (!LeaveOpen)
            _stream.Dispose();
    }

    private void Write(BlockKind kind, BlockEncoding encoding, long time, Span<byte> block)
    {
        ReadOnlySpan<byte> payload = block[RecordingLayout.BlockHeaderSize..];
        new BlockHeader(kind, encoding, _sequence++, payload.Length, time, Crc32C.Append(0, payload)).Write(block, _seed);
        Write(block);
    }

    private void Write(ReadOnlySpan<byte> bytes)
    {
        if (_hasFailed)
            return;

        try
        {
            _stream.Write(bytes);
            Length += bytes.Length;
        }
        catch
        {
            _hasFailed = true;
            CutOff();
            throw;
        }
    }

    // A full disk still allows shortening a file. The caller receives the original failure.
    private void CutOff()
    {
        try
        {
            if (_stream.CanSeek && _stream.Length > _start + Length)
                _stream.SetLength(_start + Length);
        }
        catch (Exception exception) when (exception is IOException or NotSupportedException or ObjectDisposedException)
        {
        }
    }
}
