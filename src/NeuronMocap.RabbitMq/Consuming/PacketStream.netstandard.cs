namespace NeuronMocap.RabbitMq.Consuming;

internal sealed partial class PacketStream
{
    public override async Task<int> ReadAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken) =>
        Check(await _bytes.ReadAsync(buffer, offset, count, cancellationToken).ConfigureAwait(false), count);
}
