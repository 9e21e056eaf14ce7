using NeuronMocap.Transport;

namespace NeuronMocap.Server.Clients;

// Each opening is a recipient of the broadcast. The stream waits in blocking reads, so its reader always has a thread of its own: on threads of the pool,
// some readers would occupy all of them.
internal sealed class LocalSource(string name, Func<LocalRecipient> accept) : ByteSource
{
    public override string Name => name;

    public override ValueTask<Stream> OpenAsync(CancellationToken cancellationToken) => new(new LocalStream(accept()));

    internal override ValueTask<ByteReceiver> OpenReceiverAsync(ReceiveThread wanted, CancellationToken cancellationToken) =>
        new(new BlockingStreamReceiver(new LocalStream(accept()), leaveOpen: false));

    // A live stream has no length and takes nothing. What CanSeek and CanWrite deny throws, as the contract of Stream asks.
    private sealed class LocalStream(LocalRecipient recipient) : Stream
    {
        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override int Read(byte[] buffer, int offset, int count) => recipient.Read(buffer.AsSpan(offset, count));

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        protected override void Dispose(bool disposing)
        {
            if (disposing)
                recipient.Dispose();

            base.Dispose(disposing);
        }
    }
}
