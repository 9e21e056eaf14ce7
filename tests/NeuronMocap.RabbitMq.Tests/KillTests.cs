using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;

namespace NeuronMocap.RabbitMq.Tests;

/// <summary>Tests that end the broker of all tests run while no other test does.</summary>
[CollectionDefinition(nameof(KillTests), DisableParallelization = true)]
public sealed class KillCollection;

[Collection(nameof(KillTests))]
public sealed class KillTests(SharedBroker shared)
{
    // The broker ends as in a power failure while frames arrive, and starts again. Each phase ends with a condition, not after a time.
    [Fact]
    public async Task After_the_broker_was_killed_both_sides_resume_and_count_what_is_missing()
    {
        Broker broker = await shared.GetAsync();
        await using Stage live = await Stage.StartAsync(broker, "live");
        await using Stage take = await Stage.StartAsync(broker, "take", "take");
        await using Audience audience = await Audience.StartAsync(broker, "live");
        await using Audience replay = await Audience.StartAsync(Audience.Options(broker, "take", "take"));
        FrameQueue local = live.Reader.OpenQueue(capacity: 1 << 15);
        int frame = 0;

        async Task WriteAsync(int count)
        {
            byte[][] packets = [.. Enumerable.Range(frame, count).Select(static index => TestPackets.Motion(index))];
            frame += count;
            live.Write(packets);
            take.Write(packets);
            await live.TakenAsync();
            await take.TakenAsync();
        }

        await WriteAsync(500);
        await audience.UntilAsync(500);
        await Limits.UntilAsync(() => broker.KeepsStreams);
        await WriteAsync(500);
        broker.Kill();
        await Limits.UntilAsync(() => !live.Publisher.Status.IsConnected && !take.Publisher.Status.IsConnected);
        await WriteAsync(1000);
        await broker.RestartAsync();

        // Frames arrive again when both ends have connected.
        await Limits.UntilAsync(() => live.Publisher.Status.IsConnected && take.Publisher.Status.IsConnected);
        await Limits.UntilAsync(() => audience.Source.GetStatistics().Connections == 2);
        await WriteAsync(500);
        await live.EndAsync();
        await take.EndAsync();
        await Limits.UntilAsync(() => audience.LastFrameIndex == 2499);
        await Limits.UntilAsync(() => replay.LastFrameIndex == 2499);

        // The reader at the suit noticed nothing.
        Assert.Equal(2500, live.Reader.GetStatistics().MotionFrames);
        Assert.Equal((0L, 2500), (local.Dropped, local.Count));

        // What is missing live is counted exactly: the frame indices of the test have no gaps.
        RabbitMqSourceStatistics gap = audience.Source.GetStatistics();
        Assert.Equal(2500 - audience.Packets.Length, gap.Lost);
        Assert.InRange(gap.Lost, 1000, 1500);
        Assert.Equal(0, gap.Duplicates);

        // The take has no gap, for a reader that was there all the time, and for one that comes now.
        Assert.Equal(Enumerable.Range(0, 2500).Select(static index => (uint)index), replay.FrameIndices);
        Assert.Equal(0, replay.Source.GetStatistics().Lost);
        Assert.Equal(2500, take.Publisher.GetStatistics().Confirmed);
        await using Audience late = await Audience.StartAsync(Audience.Options(broker, "take", "take"));
        await late.UntilAsync(2500);
        Assert.Equal(Enumerable.Range(0, 2500).Select(static index => (uint)index), late.FrameIndices);
    }
}
