namespace NeuronMocap.Tests.Infrastructure;

/// <summary>A stream that begins with a text and then repeats another one for ever. It cannot seek and has no length.</summary>
internal sealed class EndlessStream(byte[] start, byte[] repeated, int pieceSize = int.MaxValue) : Stream
{
    private byte[] _current = start;
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

    public override int Read(byte[] buffer, int offset, int count)
    {
        if (_position == _current.Length)
            (_current, _position) = (repeated, 0);

        int size = Math.Min(Math.Min(count, pieceSize), _current.Length - _position);
        _current.AsSpan(_position, size).CopyTo(buffer.AsSpan(offset));
        _position += size;
        return size;
    }

    public override void Flush()
    {
    }

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
}
