namespace NeuronMocap.Transport;

// A stream that is already open, and therefore has no second attempt.
internal sealed class SingleStreamSource : ByteSource
{
    private readonly Stream _stream;
    private readonly bool _leaveOpen;

    private SingleStreamSource(Stream stream, bool leaveOpen)
    {
        _stream = stream;
        _leaveOpen = leaveOpen;
    }

    internal override bool CanReopen => false;

    public static SingleStreamSource Of(Stream stream, bool leaveOpen)
    {
        ArgumentNullException.ThrowIfNull(stream);
        return stream.CanRead ? new SingleStreamSource(stream, leaveOpen) : throw new ArgumentException("The stream cannot be read.", nameof(stream));
    }

    public override ValueTask<Stream> OpenAsync(CancellationToken cancellationToken) => new(_stream);

    internal override ValueTask<ByteReceiver> OpenReceiverAsync(ReceiveThread wanted, CancellationToken cancellationToken) =>
        new(ByteReceivers.Create(_stream, _leaveOpen, wanted));

    internal override void Discard()
    {
        if (!_leaveOpen)
            _stream.Dispose();
    }
}
