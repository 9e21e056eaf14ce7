using System.IO.Pipelines;
using NeuronMocap.RabbitMq.Connecting;
using NeuronMocap.RabbitMq.Consuming;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq;

/// <summary>
/// Receives the frames of a stage from a RabbitMQ broker: live, or from a stream that keeps them. Set <see cref="NeuronReaderOptions.Source"/> of one
/// reader to it.
/// </summary>
/// <remarks>
/// <para>
/// Live frames come from a queue of this source on the broker. If the reader is too slow, the queue drops its oldest frames. A reader that waits, with
/// <see cref="WhenFull.Wait"/>, makes the broker keep up to <see cref="RabbitMqSourceOptions.QueueCapacity"/> frames, and all frames of a stream.
/// </para>
/// <para>
/// The reader connects again after a failure, as <see cref="NeuronReaderOptions.Reconnect"/> says. The source then counts the frames that it has missed, or
/// continues in its stream.
/// </para>
/// <para>
/// A source serves one reader. Frames that it has received and that reader has not taken are lost when the reader stops, and <see
/// cref="RabbitMqSourceStatistics.Lost"/> does not count them. Create a source for each reader, also for one that comes after another.
/// </para>
/// </remarks>
public sealed class RabbitMqSource : ByteSource
{
    // What the reader has not taken yet. More stays on the broker.
    private const int PipeSize = 1 << 20;

    private readonly RabbitMqSourceOptions _options;
    private readonly SourceState _state;
    private int _isOpen;

    /// <summary>Creates a source. The reader connects when it starts.</summary>
    /// <param name="options">The broker, and the frames to receive.</param>
    /// <exception cref="ArgumentException">An option is invalid; the message says which.</exception>
    public RabbitMqSource(RabbitMqSourceOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        if (options.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        _options = options.Copy();
        _state = new SourceState(_options);
        Name = _options.ToString();
    }

    /// <summary>The address of the broker and the stage, without user and password.</summary>
    public override string Name { get; }

    // Null for the usual one.
    internal TimeSpan? RestTime { get; init; }

    /// <summary>Takes the counts of this moment. Thread-safe.</summary>
    /// <returns>The counts.</returns>
    public RabbitMqSourceStatistics GetStatistics() => _state.GetStatistics();

    /// <summary>Connects to the broker. A reader calls it. Only one stream can be open at a time, because the source counts losses across streams.</summary>
    /// <param name="cancellationToken">Ends the attempt.</param>
    /// <returns>A stream of packets.</returns>
    /// <exception cref="NeuronConnectionException">The broker is not available, or refuses. The message says why in one sentence.</exception>
    /// <exception cref="InvalidOperationException">Another reader uses this source.</exception>
    /// <exception cref="OperationCanceledException">The attempt was cancelled.</exception>
    public override async ValueTask<Stream> OpenAsync(CancellationToken cancellationToken)
    {
        if (Interlocked.Exchange(ref _isOpen, 1) != 0)
            throw new InvalidOperationException("Another reader uses this source. Create a source for each reader.");

        try
        {
            return await ConnectAsync(cancellationToken).ConfigureAwait(false);
        }
        catch
        {
            Volatile.Write(ref _isOpen, 0);
            throw;
        }
    }

    private async Task<Stream> ConnectAsync(CancellationToken cancellationToken)
    {
        BrokerConnection connection = await BrokerConnection.OpenAsync(
            _options, $"NeuronMocap source, stage {_options.Stage}", channelOptions: null, cancellationToken).ConfigureAwait(false);
        PacketConsumer? consumer = null;
        try
        {
            // The pipe's threads run the reader; without schedulers, the connection would.
            var pipe = new Pipe(new PipeOptions(pauseWriterThreshold: PipeSize, resumeWriterThreshold: PipeSize / 2, useSynchronizationContext: false));
            consumer = new PacketConsumer(connection.Channel, _state, pipe.Writer, _options, RestTime);
            await ConsumeAsync(connection.Channel, consumer, cancellationToken).ConfigureAwait(false);
            _state.CountConnection();
            return new PacketStream(connection, consumer, pipe.Reader, () => Volatile.Write(ref _isOpen, 0));
        }
        catch (Exception exception)
        {
            consumer?.Stop();
            await connection.CloseAsync().ConfigureAwait(false);
            cancellationToken.ThrowIfCancellationRequested();
            throw BrokerFault.Of(exception, _options);
        }
    }

    private async Task ConsumeAsync(IChannel channel, PacketConsumer consumer, CancellationToken cancellationToken)
    {
        await channel.BasicQosAsync(prefetchSize: 0, PacketConsumer.Prefetch, global: false, cancellationToken).ConfigureAwait(false);
        string queue = _options.Stream ?? await DeclareQueueAsync(channel, cancellationToken).ConfigureAwait(false);
        var arguments = new Dictionary<string, object?>(StringComparer.Ordinal);
        if (_options.Stream is not null)
            arguments.Add("x-stream-offset", _state.Resume());

        await channel.BasicConsumeAsync(
            queue, autoAck: false, consumerTag: string.Empty, noLocal: false, exclusive: false, arguments, consumer, cancellationToken).ConfigureAwait(false);
    }

    // The broker removes the queue when the connection ends.
    private async Task<string> DeclareQueueAsync(IChannel channel, CancellationToken cancellationToken)
    {
        await channel.ExchangeDeclareAsync(_options.Exchange, ExchangeType.Topic, durable: true, autoDelete: false, cancellationToken: cancellationToken)
            .ConfigureAwait(false);
        var arguments = new Dictionary<string, object?>(StringComparer.Ordinal) { ["x-max-length"] = _options.QueueCapacity, ["x-overflow"] = "drop-head" };
        QueueDeclareOk queue = await channel.QueueDeclareAsync(
            string.Empty, durable: false, exclusive: true, autoDelete: true, arguments, cancellationToken: cancellationToken).ConfigureAwait(false);
        string pattern = RabbitMqRoutingKey.CreatePattern(_options.Stage, _options.Avatar, _options.Kind);
        await channel.QueueBindAsync(queue.QueueName, _options.Exchange, pattern, cancellationToken: cancellationToken).ConfigureAwait(false);
        return queue.QueueName;
    }
}
