namespace NeuronMocap.Files;

// Collects rows of text and passes them to a stream in large pieces.
internal sealed class RowOutput(Stream stream, bool leavesOpen, int longestPiece) : IDisposable
{
    private const int Size = 1 << 16;

    private readonly byte[] _buffer = new byte[Size + longestPiece];
    private int _length;

    public bool IsDisposed { get; private set; }

    // Room for the longest piece. Write into it, and call Advance.
    public Span<byte> Free => _buffer.AsSpan(_length);

    public void Advance(int count)
    {
        _length += count;
        if (_length >= Size)
            Flush();
    }

    // Text may be longer than the longest piece.
    public void Write(ReadOnlySpan<byte> text)
    {
        while (text.Length > 0)
        {
            int count = Math.Min(text.Length, Free.Length);
            text[..count].CopyTo(Free);
            text = text[count..];
            Advance(count);
        }
    }

    public void Flush()
    {
        stream.Write(_buffer, 0, _length);
        _length = 0;
    }

    public void Dispose()
    {
        if (IsDisposed)
            return;

        IsDisposed = true;
        try
        {
            Flush();
        }
        finally
        {
            if (!leavesOpen)
                stream.Dispose();
        }
    }
}
