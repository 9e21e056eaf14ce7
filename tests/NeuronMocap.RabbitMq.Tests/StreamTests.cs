using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class StreamTests(SharedBroker shared)
{
    [Fact]
    public async Task A_late_joiner_gets_the_take_from_its_beginning_and_then_live_frames()
    {
        Broker broker = await shared.GetAsync();
        await using Stage stage = await Stage.RecordAsync(broker, "late", 300);
        await using Audience audience = await Audience.StartAsync(Audience.Options(broker, "late", "late"));

        await audience.UntilAsync(300);
        stage.Write(TestPackets.Motion(300));
        await audience.UntilAsync(301);

        Assert.Equal(Enumerable.Range(0, 301).Select(static frame => TestPackets.Motion(frame)), audience.Packets);
        Assert.Equal(300, audience.Source.GetStatistics().LastOffset);
    }

    [Fact]
    public async Task A_take_remains_after_its_publisher()
    {
        Broker broker = await shared.GetAsync();
        await using (Stage stage = await Stage.RecordAsync(broker, "kept", 100))
            await stage.EndAsync();

        await using Audience audience = await Audience.StartAsync(Audience.Options(broker, "kept", "kept"));
        await audience.UntilAsync(100);

        Assert.Equal(Enumerable.Range(0, 100).Select(static frame => (uint)frame), audience.FrameIndices);
    }

    [Fact]
    public async Task A_source_begins_at_a_message_that_it_names()
    {
        Broker broker = await shared.GetAsync();
        await using Stage stage = await Stage.RecordAsync(broker, "offset", 100);
        RabbitMqSourceOptions options = Audience.Options(broker, "offset", "offset");
        options.From = RabbitMqStreamStart.AtOffset(70);
        await using Audience audience = await Audience.StartAsync(options);

        await audience.UntilAsync(30);

        Assert.Equal(Enumerable.Range(70, 30).Select(static frame => (uint)frame), audience.FrameIndices);
    }

    // The broker finds the part of the stream with this second. The source leaves out what is earlier.
    [Fact]
    public async Task A_source_begins_at_a_time()
    {
        Broker broker = await shared.GetAsync();
        await using Stage stage = await Stage.RecordAsync(broker, "time", 100);
        await Limits.UntilAsync(Later(DateTimeOffset.UtcNow));
        DateTimeOffset time = DateTimeOffset.UtcNow;
        stage.Write(Enumerable.Range(100, 50).Select(static frame => TestPackets.Motion(frame)));
        await stage.ConfirmedAsync(150);

        RabbitMqSourceOptions options = Audience.Options(broker, "time", "time");
        options.From = RabbitMqStreamStart.AtTime(time);
        await using Audience audience = await Audience.StartAsync(options);
        await audience.UntilAsync(50);

        Assert.Equal(Enumerable.Range(100, 50).Select(static frame => (uint)frame), audience.FrameIndices);
    }

    [Fact]
    public async Task A_source_takes_one_avatar_and_one_kind_out_of_a_stream()
    {
        Broker broker = await shared.GetAsync();
        await using Stage stage = await Stage.StartAsync(broker, "choice", "choice");
        for (int frame = 0; frame < 50; frame++)
            stage.Write(TestPackets.Motion(frame, avatar: 0, name: "A"), TestPackets.Motion(frame, avatar: 1, name: "B"), TestPackets.Calculation(frame));

        await stage.ConfirmedAsync(150);
        RabbitMqSourceOptions options = Audience.Options(broker, "choice", "choice");
        (options.Avatar, options.Kind) = ("B", PacketKind.Motion);
        await using Audience audience = await Audience.StartAsync(options);
        await audience.UntilAsync(50);
        await Limits.UntilAsync(() => audience.Source.GetStatistics().Skipped == 100);

        Assert.Equal(Enumerable.Range(0, 50).Select(static frame => TestPackets.Motion(frame, avatar: 1, name: "B")), audience.Packets);
        Assert.Equal(0, audience.Source.GetStatistics().Lost);
    }

    // A handler that waits makes the broker wait. A live source would lose most of these frames.
    [Fact]
    public async Task A_slow_source_loses_nothing_of_a_stream()
    {
        const int Count = 3000;
        Broker broker = await shared.GetAsync();
        await using Stage stage = await Stage.RecordAsync(broker, "slow stream", Count);
        RabbitMqSourceOptions options = Audience.Options(broker, "slow stream", "slow stream");
        options.QueueCapacity = 1;
        await using Audience audience = await Audience.StartAsync(options);

        audience.Hold();
        await Limits.UntilAsync(() => audience.Source.GetStatistics().Packets > 500);
        audience.Resume();
        await audience.UntilAsync(Count);

        Assert.Equal(Enumerable.Range(0, Count).Select(static frame => (uint)frame), audience.FrameIndices);
    }

    [Fact]
    public async Task A_stream_that_is_deleted_is_declared_again_and_gets_what_was_not_confirmed()
    {
        Broker broker = await shared.GetAsync();
        await using Stage stage = await Stage.RecordAsync(broker, "deleted", 10);
        await broker.DeleteQueueAsync("deleted");
        stage.Write(TestPackets.Motion(10));
        await stage.ConfirmedAsync(11);
        await using Audience audience = await Audience.StartAsync(Audience.Options(broker, "deleted", "deleted"));
        await audience.UntilAsync(1);

        Assert.Equal([10], audience.FrameIndices);
        Assert.Equal(1, stage.Publisher.GetStatistics().Repeated);
    }

    // Headers have microseconds, and the clock ticks in larger steps on some systems.
    private static Func<bool> Later(DateTimeOffset time) => () => DateTimeOffset.UtcNow > time.AddMilliseconds(20);
}
