namespace NeuronMocap.Files;

// Collects rows of text and passes them to a stream in large pieces. After a failure of the stream, nothing more is written: nobody knows how much
// of the failed piece the stream has accepted.
internal sealed class RowOutput(Stream stream, bool leavesOpen, int longestPiece) : IDisposable
{
    private const int Size = 1 << 16;

    private readonly byte[] _buffer = new byte[Size + longestPiece];
    private int _length;
    private Exception? _failure;

    public bool IsDisposed { get; private set; }

    public bool HasFailed => _failure is not null;

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
        try
        {
            if (_failure is not null)
                throw new IOException(_failure.Message, _failure);

            stream.Write(_buffer, 0, _length);
        }
        catch (Exception exception)
        {
            _failure ??= exception;
            throw;
        }
        finally
        {
            // After a failure, the next piece still fits. It fills the buffer, and fails too.
            _length = HasFailed ? Size : 0;
        }
    }

    public void Dispose()
    {
        if (IsDisposed)
            return;

        IsDisposed = true;
        try
        {
            if (!HasFailed)
                Flush();
        }
        finally
        {
            if (!leavesOpen)
                stream.Dispose();
        }
    }
}
