using System.IO.Pipelines;
using NeuronMocap.RabbitMq.Connecting;
using RabbitMQ.Client;
using RabbitMQ.Client.Events;

namespace NeuronMocap.RabbitMq.Consuming;

// Writes the packets of one connection into a pipe. The client calls it for one message at a time. While the pipe is full it waits, and acknowledges
// nothing, so the messages stay on the broker.
internal sealed class PacketConsumer(IChannel channel, SourceState state, PipeWriter writer, RabbitMqSourceOptions options) : AsyncDefaultBasicConsumer(channel)
{
    // The broker sends this many messages ahead. Acknowledgements are for several messages, and leave time for the way back.
    public const ushort Prefetch = 512;

    private const int AcknowledgeEvery = 64;

    private int _unacknowledged;
    private NeuronConnectionException? _failure;

    // Why the connection ended; set before the pipe ends.
    public NeuronConnectionException? Failure => Volatile.Read(ref _failure);

    public override async Task HandleBasicDeliverAsync(
        string consumerTag,
        ulong deliveryTag,
        bool redelivered,
        string exchange,
        string routingKey,
        IReadOnlyBasicProperties properties,
        ReadOnlyMemory<byte> body,
        CancellationToken cancellationToken = default)
    {
        if (Failure is not null)
            return;

        if (state.Take(routingKey, properties.Headers, body.Span))
        {
            FlushResult result = await writer.WriteAsync(body, CancellationToken.None).ConfigureAwait(false);
            if (result.IsCompleted)
                return;
        }

        if (++_unacknowledged < AcknowledgeEvery)
            return;

        _unacknowledged = 0;
        await Channel.BasicAckAsync(deliveryTag, multiple: true, cancellationToken).ConfigureAwait(false);
    }

    public override Task HandleChannelShutdownAsync(object channel, ShutdownEventArgs reason)
    {
        Fail(BrokerFault.Of(reason, options));
        return Task.CompletedTask;
    }

    // The queue was deleted.
    public override Task HandleBasicCancelAsync(string consumerTag, CancellationToken cancellationToken = default)
    {
        Fail(new NeuronConnectionException(
            ConnectionReason.ClosedByPeer, $"The queue or stream on the broker {AmqpAddress.EndPoint(options)} was deleted."));
        return Task.CompletedTask;
    }

    // Before the reader lets go of the stream. A message that comes later belongs to the next connection, or is lost.
    public void Stop() => Interlocked.CompareExchange(ref _failure, new NeuronConnectionException(ConnectionReason.Requested, "The stream was closed."), null);

    private void Fail(NeuronConnectionException failure)
    {
        if (Interlocked.CompareExchange(ref _failure, failure, null) is null)
            writer.Complete();
    }
}
