using System.IO.Pipelines;
using NeuronMocap.RabbitMq.Connecting;
using NeuronMocap.Transport;

namespace NeuronMocap.RabbitMq.Consuming;

// The bytes of one connection. After the last one, a read throws the reason of the end: a pipe that fails would discard what it still holds.
internal sealed partial class PacketStream(BrokerConnection connection, PacketConsumer consumer, PipeReader reader, Action closed) : ReadOnlyStream
{
    private readonly Stream _bytes = reader.AsStream();
    private int _isClosed;

    public override int Read(byte[] buffer, int offset, int count) => Check(_bytes.Read(buffer, offset, count), count);

    // Returns at once: the connection closes in the background, so that a broker that hangs does not delay the reader.
    protected override void Dispose(bool disposing)
    {
        if (disposing && Interlocked.Exchange(ref _isClosed, 1) == 0)
        {
            consumer.Stop();
            reader.CancelPendingRead();
            reader.Complete();
            _ = Task.Run(connection.CloseAsync);
            closed();
        }

        base.Dispose(disposing);
    }

    // A read of zero bytes only waits.
    private int Check(int count, int wanted) => count == 0 && wanted > 0 && consumer.Failure is { } failure ? throw failure : count;
}
