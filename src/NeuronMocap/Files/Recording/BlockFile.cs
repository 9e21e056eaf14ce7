namespace NeuronMocap.Recording;

// Finds and reads the blocks of a file, including those after damaged sections. It holds one block in memory, both as stored and unpacked.
internal sealed class BlockFile
{
    private const int MinCapacity = 4096;

    private readonly Stream _stream;
    private readonly uint _seed;
    private readonly byte[] _window = new byte[MinCapacity];
    private byte[] _stored = new byte[MinCapacity];
    private byte[] _unpacked = [];

    // Throws RecordingFormatException.
    public BlockFile(Stream stream)
    {
        _stream = stream;
        Length = stream.Length;
        Header = RecordingHeader.Read(_window.AsSpan(0, Fill(0, _window.AsSpan(0, RecordingLayout.FileHeaderSize))), out _seed);
    }

    public RecordingHeader Header { get; }

    // The length when the file was opened. Data written later is not read.
    public long Length { get; }

    // Finds the next block at or after an offset and returns its offset; -1 if there is none. The payload is within the file but not checked.
    public long Find(long offset, out BlockHeader header)
    {
        if (TryReadHeader(offset, out header))
            return offset;

        while (true)
        {
            ReadOnlySpan<byte> window = _window.AsSpan(0, Fill(offset, _window));
            if (window.Length < RecordingLayout.BlockHeaderSize)
                return -1;

            // If a marker is too near to the end of the window, the search repeats from there.
            int start = 0;
            int found;
            while ((found = window[start..].IndexOf(BlockHeader.Marker)) >= 0 && window.Length - start - found >= RecordingLayout.BlockHeaderSize)
            {
                start += found;
                if (IsBlock(window[start..], offset + start, out header))
                    return offset + start;

                start++;
            }

            offset += found >= 0 ? start + found : window.Length - BlockHeader.Marker.Length + 1;
        }
    }

    public bool TryReadHeader(long offset, out BlockHeader header)
    {
        header = default;
        Span<byte> bytes = stackalloc byte[RecordingLayout.BlockHeaderSize];
        return offset >= RecordingLayout.FileHeaderSize && Length - offset >= bytes.Length
            && Fill(offset, bytes) == bytes.Length && IsBlock(bytes, offset, out header);
    }

    // Returns false if the payload is damaged. The payload is in this object's memory and valid until the next call.
    public bool TryReadPayload(long offset, in BlockHeader header, out ArraySegment<byte> payload)
    {
        payload = default;
        if (_stored.Length < header.Length)
            _stored = new byte[Math.Min(RecordingLayout.MaxPayload, Math.Max(header.Length, 2 * _stored.Length))];

        Span<byte> stored = _stored.AsSpan(0, header.Length);
        if (Fill(offset + RecordingLayout.BlockHeaderSize, stored) < stored.Length || Crc32C.Append(0, stored) != header.Checksum)
            return false;

        switch (header.Encoding)
        {
            case BlockEncoding.Plain:
                payload = new ArraySegment<byte>(_stored, 0, header.Length);
                return true;
            case BlockEncoding.Deflate when BlockCompression.TryUnpack(_stored, 0, header.Length, ref _unpacked, out int length):
                payload = new ArraySegment<byte>(_unpacked, 0, length);
                return true;
            default:
                return false;
        }
    }

    private bool IsBlock(ReadOnlySpan<byte> bytes, long offset, out BlockHeader header) =>
        BlockHeader.TryRead(bytes, _seed, out header) && header.Length <= Length - offset - RecordingLayout.BlockHeaderSize;

    private int Fill(long offset, Span<byte> destination)
    {
        _stream.Position = offset;
        return StreamReads.Fill(_stream, destination);
    }
}
