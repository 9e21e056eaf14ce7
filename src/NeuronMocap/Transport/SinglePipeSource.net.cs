using System.IO.Pipelines;

namespace NeuronMocap.Transport;

// A pipe, which has no second attempt.
internal sealed class SinglePipeSource(PipeReader pipe) : ByteSource
{
    public override string Name => "the pipe";

    internal override bool CanReopen => false;

    public override ValueTask<Stream> OpenAsync(CancellationToken cancellationToken) => new(pipe.AsStream());

    internal override ValueTask<ByteReceiver> OpenReceiverAsync(ReceiveThread wanted, CancellationToken cancellationToken) => new(new PipeReceiver(pipe));

    internal override void Discard() => pipe.Complete();
}
