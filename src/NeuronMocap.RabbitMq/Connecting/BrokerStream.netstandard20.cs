namespace NeuronMocap.RabbitMq.Connecting;

internal sealed partial class BrokerStream
{
    public override async Task<int> ReadAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken) =>
        Check(await base.ReadAsync(buffer, offset, count, cancellationToken).ConfigureAwait(false), count);
}
