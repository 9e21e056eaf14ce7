namespace NeuronMocap.Transport;

// A live stream has no length, no position, and takes nothing. What CanSeek and CanWrite deny throws, as the contract of Stream asks.
internal abstract class ReadOnlyStream : Stream
{
    public sealed override bool CanRead => true;

    public sealed override bool CanSeek => false;

    public sealed override bool CanWrite => false;

    public sealed override long Length => throw NoPosition();

    public sealed override long Position
    {
        get => throw NoPosition();
        set => throw NoPosition();
    }

    public sealed override void Flush()
    {
    }

    public sealed override long Seek(long offset, SeekOrigin origin) => throw NoPosition();

    public sealed override void SetLength(long value) => throw NoPosition();

    public sealed override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException("The stream is read-only.");

    private static NotSupportedException NoPosition() => new("A live stream has no length and no position.");
}
