namespace NeuronMocap.Fuzz.Inputs;

/// <summary>The input as from a pipe: in pieces of any size, most of them small.</summary>
internal sealed class FuzzStream(FuzzInput input) : Stream
{
    private const int LargestPiece = 4096;

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
        int size = Math.Min(Math.Min(count, input.Random.Small(LargestPiece) + 1), input.Bytes.Length - _position);
        input.Bytes.Slice(_position, size).CopyTo(buffer.AsSpan(offset));
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
