namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// A stream that returns its bytes in pieces of given sizes, like a pipe. It cannot seek and has no length. With a place to repeat from, it never ends.
/// </summary>
internal sealed class PieceStream(byte[] bytes, Func<int> nextSize, int? repeatFrom = null) : Stream
{
    private int _position;

    public override bool CanRead => true;

    public override bool CanSeek => false;

    public override bool CanWrite => false;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    /// <summary>The number of bytes taken, since the last repetition.</summary>
    public int Taken => _position;

    public bool IsClosed { get; private set; }

    public override int Read(byte[] buffer, int offset, int count)
    {
        if (_position == bytes.Length)
            _position = repeatFrom ?? _position;

        int size = Math.Min(Math.Min(count, Math.Max(1, nextSize())), bytes.Length - _position);
        bytes.AsSpan(_position, size).CopyTo(buffer.AsSpan(offset));
        _position += size;
        return size;
    }

    public override void Flush()
    {
    }

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    protected override void Dispose(bool disposing)
    {
        IsClosed = true;
        base.Dispose(disposing);
    }
}
