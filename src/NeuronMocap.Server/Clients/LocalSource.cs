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

    private sealed class LocalStream(LocalRecipient recipient) : ReadOnlyStream
    {
        public override int Read(byte[] buffer, int offset, int count) => recipient.Read(buffer.AsSpan(offset, count));

        protected override void Dispose(bool disposing)
        {
            if (disposing)
                recipient.Dispose();

            base.Dispose(disposing);
        }
    }
}
