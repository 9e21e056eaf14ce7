using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class StreamClockTests(SharedBroker shared)
{
    private const int Count = 10;

    // Frames of a computer whose clock is ahead, from 60 s later than now. The broker has no part of the stream from such a time.
    [Fact]
    public async Task A_source_begins_at_a_time_of_a_clock_that_is_ahead_of_the_broker()
    {
        Broker broker = await shared.GetAsync();
        await using Stage stage = await Stage.StartAsync(broker, "ahead", "ahead");
        DateTimeOffset first = DateTimeOffset.UtcNow.AddSeconds(60);
        await using IConnection connection = await new ConnectionFactory { HostName = "127.0.0.1", Port = broker.Port }
            .CreateConnectionAsync(TestContext.Current.CancellationToken);
        await using IChannel channel = await connection.CreateChannelAsync(
            new CreateChannelOptions(publisherConfirmationsEnabled: true, publisherConfirmationTrackingEnabled: true), TestContext.Current.CancellationToken);
        for (int frame = 0; frame < Count; frame++)
        {
            long captured = first.AddSeconds(frame).ToUnixTimeMilliseconds() * 1000;
            var properties = new BasicProperties { Headers = new Dictionary<string, object?>(StringComparer.Ordinal) { ["captured"] = captured } };
            await channel.BasicPublishAsync(
                RabbitMqOptions.DefaultExchange, "ahead.x.motion", mandatory: true, properties, TestPackets.Motion(frame), TestContext.Current.CancellationToken);
        }

        RabbitMqSourceOptions options = Audience.Options(broker, "ahead", "ahead");
        options.From = RabbitMqStreamStart.AtTime(first.AddSeconds(4.5));
        await using Audience audience = await Audience.StartAsync(options);
        await audience.UntilAsync(5);

        Assert.Equal([5U, 6, 7, 8, 9], audience.FrameIndices);
    }
}
