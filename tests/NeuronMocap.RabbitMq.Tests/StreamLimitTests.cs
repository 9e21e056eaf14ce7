using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class StreamLimitTests(SharedBroker shared)
{
    // The broker keeps the limit and one segment of 1 MB, and removes the rest some time after it has confirmed a frame.
    [Fact]
    public async Task A_small_stream_keeps_its_limit()
    {
        const int Limit = 2_000_000, Segment = 1_000_000, Step = 1000, Count = 6 * Step;
        Broker broker = await shared.GetAsync();
        RabbitMqPublisherOptions options = Stage.Options(broker, "small", "small");
        options.StreamMaxBytes = Limit;
        await using Stage stage = await Stage.StartAsync(options);
        for (int first = 0; first < Count; first += Step)
        {
            stage.Write(Enumerable.Range(first, Step).Select(static frame => TestPackets.Motion(frame)));
            await stage.ConfirmedAsync(first + Step);
        }

        using var limit = new CancellationTokenSource(Limits.Unexpected);
        while (await CountBytesAsync(broker, Count - 1) > Limit + Segment)
            Assert.False(limit.IsCancellationRequested, "The stream is larger than its limit.");
    }

    private static async Task<long> CountBytesAsync(Broker broker, uint last)
    {
        await using Audience audience = await Audience.StartAsync(Audience.Options(broker, "small", "small"));
        await Limits.UntilAsync(() => audience.LastFrameIndex == last);
        return audience.Source.GetStatistics().Bytes;
    }
}
