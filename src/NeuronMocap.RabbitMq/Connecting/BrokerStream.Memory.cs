namespace NeuronMocap.RabbitMq.Connecting;

internal sealed partial class BrokerStream
{
    public override Task<int> ReadAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken) =>
        ReadAsync(buffer.AsMemory(offset, count), cancellationToken).AsTask();

    public override async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default) =>
        Check(await base.ReadAsync(buffer, cancellationToken).ConfigureAwait(false), buffer.Length);
}
