using System.Buffers;

namespace NeuronMocap.Bvh;

// Holds a stream, the piece of it in memory, and the position of BvhText between two calls.
internal sealed class BvhTextSource(Stream stream, IProgress<long>? progress)
{
    // Room for the longest word twice, so that data is rarely moved.
    private const int BufferSize = 2 * BvhText.LongestWord;

    private byte[]? _buffer = ArrayPool<byte>.Shared.Rent(BufferSize);
    private int _end;

    public BvhText.Cursor Cursor { get; set; } = BvhText.Cursor.Start;

    public long BytesRead { get; private set; }

    public bool IsEnded { get; private set; }

    /// <summary>Number of bytes from the current position to the end of the stream; null when unknown.</summary>
    public long? Remaining => stream.CanSeek ? Math.Max(0, stream.Length - stream.Position) : null;

    public ReadOnlySpan<byte> Window => _buffer.AsSpan(0, _end);

    /// <summary>Reads the next piece. If there is no room, the bytes before a position are discarded.</summary>
    /// <returns>The number of discarded bytes.</returns>
    public int Fill(int position)
    {
        byte[] buffer = _buffer ?? throw new ObjectDisposedException(nameof(BvhReader));
        int forgotten = 0;
        if (_end == buffer.Length || position == _end)
        {
            buffer.AsSpan(position, _end - position).CopyTo(buffer);
            _end -= position;
            forgotten = position;
        }

        int read = stream.Read(buffer, _end, buffer.Length - _end);
        IsEnded = read == 0;
        _end += read;
        BytesRead += read;
        progress?.Report(BytesRead);
        return forgotten;
    }

    public void Release()
    {
        if (_buffer is not null)
            ArrayPool<byte>.Shared.Return(_buffer);

        _buffer = null;
        _end = 0;
        IsEnded = true;
    }
}
