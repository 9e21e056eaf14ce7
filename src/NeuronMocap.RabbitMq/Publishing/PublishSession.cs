using System.Diagnostics.CodeAnalysis;
using NeuronMocap.RabbitMq.Connecting;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq.Publishing;

// Publishes over one connection, until nothing is left or the connection fails.
[SuppressMessage("Design", "CA1001", Justification = "The source has no timer, and the connection may still cancel it.")]
internal sealed class PublishSession
{
    private readonly RabbitMqPublisherOptions _options;
    private readonly Outbox _outbox;
    private readonly BrokerConnection _connection;
    private readonly CancellationTokenSource _failSource = new();
    private NeuronConnectionException? _failure;

    private PublishSession(RabbitMqPublisherOptions options, Outbox outbox, BrokerConnection connection, Action<string?> blocked)
    {
        (_options, _outbox, _connection) = (options, outbox, connection);
        connection.Channel.ChannelShutdownAsync += (_, reason) => FailAsync(BrokerFault.Of(reason, options));
        connection.Connection.ConnectionBlockedAsync += (_, reason) =>
        {
            blocked($"The broker {AmqpAddress.EndPoint(options)} accepts no frames for now: {reason.Reason}.");
            return Task.CompletedTask;
        };
        connection.Connection.ConnectionUnblockedAsync += (_, _) =>
        {
            blocked(null);
            return Task.CompletedTask;
        };
        if (!Confirms)
            return;

        // The broker also confirms what it has returned. The next connection sends it again, and declares a stream that somebody has deleted.
        connection.Channel.BasicAcksAsync += (_, ack) =>
        {
            if (Volatile.Read(ref _failure) is null)
                _outbox.Confirm(ack.DeliveryTag, ack.Multiple);
            return Task.CompletedTask;
        };
        connection.Channel.BasicNacksAsync += (_, _) => FailAsync(Refused("The broker could not store a frame."));
        connection.Channel.BasicReturnAsync += (_, _) => FailAsync(Refused($"The stream '{options.Stream}' was deleted."));
    }

    private bool Confirms => _options.Stream is not null;

    // blocked: gets the reason why the broker takes nothing for now, and null when it takes frames again.
    public static async Task<PublishSession> OpenAsync(
        RabbitMqPublisherOptions options, Outbox outbox, Action<string?> blocked, CancellationToken cancellationToken)
    {
        bool confirms = options.Stream is not null;
        BrokerConnection connection = await BrokerConnection.OpenAsync(
            options, $"NeuronMocap publisher, stage {options.Stage}", new CreateChannelOptions(confirms, publisherConfirmationTrackingEnabled: false), cancellationToken)
            .ConfigureAwait(false);
        try
        {
            await DeclareAsync(connection.Channel, options, cancellationToken).ConfigureAwait(false);
            return new PublishSession(options, outbox, connection, blocked);
        }
        catch (Exception exception)
        {
            await connection.CloseAsync().ConfigureAwait(false);
            cancellationToken.ThrowIfCancellationRequested();
            throw BrokerFault.Of(exception, options);
        }
    }

    // Returns when the outbox is complete and empty. Otherwise it throws the reason.
    public async Task RunAsync(CancellationToken cancellationToken)
    {
        using var stopSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, _failSource.Token);
        try
        {
            if (!_connection.Channel.IsOpen)
                throw _failure ?? Refused("The connection was lost.");

            while (await _outbox.WaitAsync(stopSource.Token).ConfigureAwait(false))
            {
                while (_outbox.Take() is { } parcel)
                    await PublishAsync(parcel, stopSource.Token).ConfigureAwait(false);
            }
        }
        catch (Exception exception)
        {
            cancellationToken.ThrowIfCancellationRequested();

            // From here on, no confirmation counts: the next connection numbers its messages from 1 again.
            NeuronConnectionException fault = BrokerFault.Of(exception, _options);
            throw Interlocked.CompareExchange(ref _failure, fault, null) ?? fault;
        }
        finally
        {
            await _connection.CloseAsync().ConfigureAwait(false);
        }
    }

    private static async Task DeclareAsync(IChannel channel, RabbitMqPublisherOptions options, CancellationToken cancellationToken)
    {
        await channel.ExchangeDeclareAsync(options.Exchange, ExchangeType.Topic, durable: true, autoDelete: false, cancellationToken: cancellationToken)
            .ConfigureAwait(false);
        if (options.Stream is not { } stream)
            return;

        var arguments = new Dictionary<string, object?>(StringComparer.Ordinal) { ["x-queue-type"] = "stream" };
        if (options.StreamMaxBytes is { } limit)
        {
            // The broker removes whole segments, which have 500 MB unless a stream says otherwise.
            arguments.Add("x-max-length-bytes", limit);
            arguments.Add("x-stream-max-segment-size-bytes", Math.Clamp(limit / 4, 1_000_000, 500_000_000));
        }

        await channel.QueueDeclareAsync(stream, durable: true, exclusive: false, autoDelete: false, arguments, cancellationToken: cancellationToken)
            .ConfigureAwait(false);
        await channel.QueueBindAsync(stream, options.Exchange, RabbitMqRoutingKey.CreatePattern(options.Stage), cancellationToken: cancellationToken)
            .ConfigureAwait(false);
    }

    private async ValueTask PublishAsync(Parcel parcel, CancellationToken cancellationToken)
    {
        Route route = parcel.Route;
        int length = parcel.Bytes.Length;
        route.SetHeaders(parcel.Number, parcel.Captured);
        try
        {
            await _connection.Channel.BasicPublishAsync(_options.Exchange, route.Key, mandatory: Confirms, route.Properties, parcel.Bytes, cancellationToken)
                .ConfigureAwait(false);
        }
        catch
        {
            _outbox.CountUnsent(parcel);
            throw;
        }

        _outbox.CountPublished(parcel, length);
    }

    private NeuronConnectionException Refused(string message) => new(ConnectionReason.NetworkError, $"{AmqpAddress.EndPoint(_options)}: {message}");

    private Task FailAsync(NeuronConnectionException failure)
    {
        // The continuations close the connection, which waits for the thread that reports the failure.
        Interlocked.CompareExchange(ref _failure, failure, null);
        _ = Task.Run(_failSource.Cancel);
        return Task.CompletedTask;
    }
}
