using System.IO.Pipelines;

namespace NeuronMocap.Transport;

// Pipes that the application opens one after another.
internal sealed class PipeSource(Func<CancellationToken, ValueTask<PipeReader>> open, string name) : ByteSource
{
    public override string Name => name;

    public override async ValueTask<Stream> OpenAsync(CancellationToken cancellationToken) => (await OpenPipeAsync(cancellationToken).ConfigureAwait(false)).AsStream();

    internal override async ValueTask<ByteReceiver> OpenReceiverAsync(ReceiveThread wanted, CancellationToken cancellationToken) =>
        new PipeReceiver(await OpenPipeAsync(cancellationToken).ConfigureAwait(false));

    private async ValueTask<PipeReader> OpenPipeAsync(CancellationToken cancellationToken) =>
        await open(cancellationToken).ConfigureAwait(false) ?? throw new InvalidOperationException("The source returned no pipe.");
}
