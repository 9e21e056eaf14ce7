using NeuronMocap.RabbitMq;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A stage of a broker that is being published to.</summary>
/// <param name="publisher">The publisher, started.</param>
/// <param name="name">The destination, without a password.</param>
/// <param name="isKept">Whether a stream on the broker must hold every frame.</param>
internal sealed class RabbitMqOutlet(RabbitMqPublisher publisher, string name, bool isKept) : Outlet
{
    public override string Name => name;

    public override string Announcement => $"Publishing to {name}";

    public override string Noun => "packet";

    // A stream has what the broker has confirmed.
    public override OutletFigures GetFigures()
    {
        RabbitMqPublisherStatistics statistics = publisher.GetStatistics();
        RabbitMqPublisherStatus status = publisher.Status;
        return new OutletFigures(isKept ? statistics.Confirmed : statistics.Published, statistics.Dropped)
        {
            Bytes = statistics.Bytes,
            Failure = status.IsConnected || publisher.Completion.IsCompleted ? null : status.Message,
        };
    }

    public override async Task<bool> FinishAsync(StandardStreams streams)
    {
        await publisher.Completion.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        await publisher.DisposeAsync();
        RabbitMqPublisherStatistics statistics = publisher.GetStatistics();
        long missing = statistics.Dropped + statistics.Waiting + statistics.Unconfirmed;
        if (!isKept || missing == 0)
            return true;

        await streams.ComplainAsync(Quantity.Format($"{name}: the stream lacks {missing} {Quantity.Noun(missing, "packet")}. The broker was away or too slow for too long."));
        return false;
    }

    public override ValueTask DisposeAsync() => publisher.DisposeAsync();
}
