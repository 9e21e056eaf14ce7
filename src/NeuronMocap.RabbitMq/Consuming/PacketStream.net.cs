namespace NeuronMocap.RabbitMq.Consuming;

internal sealed partial class PacketStream
{
    public override Task<int> ReadAsync(byte[] buffer, int offset, int count, CancellationToken cancellationToken) =>
        ReadAsync(buffer.AsMemory(offset, count), cancellationToken).AsTask();

    public override async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default) =>
        Check(await _bytes.ReadAsync(buffer, cancellationToken).ConfigureAwait(false), buffer.Length);
}
