using System.Diagnostics.CodeAnalysis;
using System.IO.Pipelines;
using NeuronMocap.RabbitMq.Connecting;
using RabbitMQ.Client;
using RabbitMQ.Client.Events;

namespace NeuronMocap.RabbitMq.Consuming;

// Writes the packets of one connection into a pipe. The client calls it for one message at a time. While the pipe is full it waits, and acknowledges
// nothing, so the messages stay on the broker.
[SuppressMessage("Design", "CA1001", Justification = "Stop disposes the timer. The semaphore holds no handle.")]
internal sealed class PacketConsumer : AsyncDefaultBasicConsumer
{
    // The broker sends this many messages ahead. Acknowledgements are for several messages, and leave time for the way back.
    public const ushort Prefetch = 512;

    private const int AcknowledgeEvery = 64;

    // An intact stream begins at once. If it takes longer, the next connection begins a little earlier than it must.
    private const int RestsBeforeStream = 2;

    // A broker closes a channel whose messages are not acknowledged for a time, usually 30 minutes. A suit can rest for longer.
    private static readonly TimeSpan RestTime = TimeSpan.FromSeconds(5);

    private readonly SourceState _state;
    private readonly PipeWriter _writer;
    private readonly RabbitMqSourceOptions _options;
    private readonly SemaphoreSlim _turn = new(1);

    // A message is counted and written, or the connection has ended before it.
    private readonly object _lock = new();
    private readonly Timer _rest;
    private int _rests;
    private ulong _taken;
    private ulong _acknowledged;
    private volatile NeuronConnectionException? _failure;

    // restTime: null for the usual one.
    public PacketConsumer(IChannel channel, SourceState state, PipeWriter writer, RabbitMqSourceOptions options, TimeSpan? restTime = null)
        : base(channel)
    {
        (_state, _writer, _options) = (state, writer, options);
        TimeSpan period = restTime ?? RestTime;
        _rest = new Timer(static self => ((PacketConsumer)self!).Rest(), this, period, period);
    }

    // Why the connection ended; set before the pipe ends.
    public NeuronConnectionException? Failure => _failure;

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
        FlushResult result = await WriteAsync(routingKey, properties.Headers, body).ConfigureAwait(false);
        if (result.IsCompleted)
            return;

        Volatile.Write(ref _taken, deliveryTag);
        if (deliveryTag - Volatile.Read(ref _acknowledged) >= AcknowledgeEvery)
            await AcknowledgeAsync(cancellationToken).ConfigureAwait(false);
    }

    public override Task HandleChannelShutdownAsync(object channel, ShutdownEventArgs reason)
    {
        Fail(BrokerFault.Of(reason, _options));
        return Task.CompletedTask;
    }

    // The queue was deleted.
    public override Task HandleBasicCancelAsync(string consumerTag, CancellationToken cancellationToken = default)
    {
        Fail(new NeuronConnectionException(
            ConnectionReason.ClosedByPeer, $"The queue or stream on the broker {AmqpAddress.EndPoint(_options)} was deleted."));
        return Task.CompletedTask;
    }

    // Before the reader lets go of the stream. A message that comes later belongs to the next connection, or is lost.
    public void Stop()
    {
        _rest.Dispose();
        lock (_lock)
            _failure ??= new NeuronConnectionException(ConnectionReason.Requested, "The stream was closed.");
    }

    // What was taken since the last time.
    internal async Task AcknowledgeRestAsync()
    {
        try
        {
            if (Failure is null)
                await AcknowledgeAsync(CancellationToken.None).ConfigureAwait(false);
        }
        catch (Exception)
        {
            // The connection has ended. Its own event tells why.
        }
    }

    // Completed if the connection has ended.
    private ValueTask<FlushResult> WriteAsync(string routingKey, IDictionary<string, object?>? headers, ReadOnlyMemory<byte> body)
    {
        lock (_lock)
        {
            if (_failure is null && !_state.IsSameStream(routingKey, headers))
                Fail(Replaced());

            if (_failure is not null)
                return new(new FlushResult(isCanceled: false, isCompleted: true));

            if (_state.Take(routingKey, headers, body.Span))
                return _writer.WriteAsync(body, CancellationToken.None);

            return default;
        }
    }

    private void Rest()
    {
        lock (_lock)
        {
            if (++_rests >= RestsBeforeStream && _failure is null && _state.IsStreamOver())
            {
                Fail(Replaced());
                return;
            }
        }

        _ = AcknowledgeRestAsync();
    }

    private NeuronConnectionException Replaced() => new(
        ConnectionReason.ClosedByPeer,
        $"The stream '{_options.Stream}' on the broker {AmqpAddress.EndPoint(_options)} is another one than before, or has lost its end.");

    // In turns, because the broker closes a channel that acknowledges a message twice.
    private async Task AcknowledgeAsync(CancellationToken cancellationToken)
    {
        await _turn.WaitAsync(cancellationToken).ConfigureAwait(false);
        try
        {
            ulong taken = Volatile.Read(ref _taken);
            if (taken == _acknowledged)
                return;

            await Channel.BasicAckAsync(taken, multiple: true, cancellationToken).ConfigureAwait(false);
            Volatile.Write(ref _acknowledged, taken);
        }
        finally
        {
            _turn.Release();
        }
    }

    private void Fail(NeuronConnectionException failure)
    {
        _rest.Dispose();
        lock (_lock)
        {
            if (_failure is not null)
                return;

            _failure = failure;
            _writer.Complete();
        }
    }
}
