using NeuronMocap.RabbitMq.Connecting;
using NeuronMocap.RabbitMq.Consuming;
using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class StreamReplacementTests(SharedBroker shared)
{
    private const string Key = "main.x.motion";

    private readonly SourceState _state = new(new RabbitMqSourceOptions { Stream = "take" });

    // The new stream has fewer messages than the old one had.
    [Fact]
    public async Task A_source_continues_with_the_stream_that_replaces_its_own()
    {
        const int Before = 300, After = 10;
        Broker broker = await shared.GetAsync();
        await using Stage stage = await Stage.RecordAsync(broker, "replaced", Before);
        await using Audience audience = await Audience.StartAsync(Audience.Options(broker, "replaced", "replaced"), restTime: TimeSpan.FromSeconds(0.5));
        await audience.UntilAsync(Before);

        await broker.DeleteQueueAsync("replaced");
        stage.Write(TestPackets.Motion(Before));
        await stage.ConfirmedAsync(Before + 1);
        stage.Write(Enumerable.Range(Before + 1, After).Select(static frame => TestPackets.Motion(frame)));
        await audience.UntilAsync(Before + 1 + After);

        Assert.Equal(Enumerable.Range(0, Before + 1 + After).Select(static frame => (uint)frame), audience.FrameIndices);
        Assert.Equal((0L, After), (audience.Source.GetStatistics().Lost, audience.Source.GetStatistics().LastOffset));
    }

    [Fact]
    public void A_source_continues_behind_its_last_message()
    {
        Take(offset: 0, number: 1);
        Take(offset: 1, number: 2);

        Assert.Equal(1L, _state.Resume());
        Assert.True(_state.IsSameStream(Key, Headers(offset: 1, number: 2)));
        Assert.False(Take(offset: 1, number: 2));
        Assert.True(Take(offset: 2, number: 3));
        Assert.False(_state.IsStreamOver());
        Assert.Equal((3L, 0L, 0L), (_state.GetStatistics().Packets, _state.GetStatistics().Duplicates, _state.GetStatistics().Lost));
    }

    [Fact]
    public void A_source_continues_where_retention_has_left_something()
    {
        Take(offset: 0, number: 1);

        Assert.Equal(0L, _state.Resume());
        Assert.True(_state.IsSameStream(Key, Headers(offset: 100, number: 101)));
        Assert.True(Take(offset: 100, number: 101));
        Assert.Equal(99, _state.GetStatistics().Lost);
    }

    [Fact]
    public void A_stream_with_another_message_at_the_offset_is_another_stream()
    {
        Take(offset: 5, number: 6);

        Assert.Equal(5L, _state.Resume());
        Assert.False(_state.IsSameStream(Key, Headers(offset: 5, number: 7)));
        Assert.IsType<AmqpTimestamp>(_state.Resume());
        Assert.True(_state.IsSameStream(Key, Headers(offset: 0, number: 1)));
        Assert.True(Take(offset: 0, number: 7));
        Assert.Equal((0L, 0L), (_state.GetStatistics().Lost, _state.GetStatistics().LastOffset));
    }

    // Somebody's clock may be years ahead, and somebody's frames have no time.
    [Theory]
    [InlineData(long.MaxValue, true)]
    [InlineData(-1L, true)]
    [InlineData(null, false)]
    public void A_stream_that_is_over_is_left_with_any_last_message(long? captured, bool hasTime)
    {
        Take(offset: 5, number: 6, captured);
        _state.Resume();

        Assert.True(_state.IsStreamOver());
        Assert.False(_state.IsStreamOver());
        Assert.Equal(hasTime, _state.Resume() is AmqpTimestamp { UnixTime: var time } && time <= DateTimeOffset.UtcNow.ToUnixTimeSeconds());
        Assert.Null(_state.GetStatistics().LastOffset);
    }

    [Fact]
    public void A_replaced_stream_begins_no_earlier_than_the_application_chose()
    {
        DateTimeOffset chosen = DateTimeOffset.UtcNow.AddHours(-1);
        var state = new SourceState(new RabbitMqSourceOptions { Stage = "stage", Stream = "takes", From = RabbitMqStreamStart.AtTime(chosen) });
        object first = state.Resume();
        Assert.False(state.Take(Key, Headers(5, 6, captured: 1_000_000), TestPackets.Motion(6)));
        state.Resume();

        Assert.True(state.IsStreamOver());
        Assert.Equal(first, state.Resume());
    }

    // Programs of others may publish packets without a time.
    [Fact]
    public void A_replaced_stream_begins_after_the_last_frame_that_has_a_time()
    {
        Take(offset: 5, number: 6, captured: 3_600_000_000);
        Take(offset: 6, number: 7, captured: null);
        _state.Resume();

        Assert.True(_state.IsStreamOver());
        Assert.Equal(new AmqpTimestamp(3600 - 300), _state.Resume());
    }

    private static Dictionary<string, object?> Headers(long offset, long number, long? captured = 1_000_000) => new(StringComparer.Ordinal)
    {
        [MessageHeaders.StreamOffset] = offset,
        [MessageHeaders.Run] = 1L,
        [MessageHeaders.Number] = number,
        [MessageHeaders.Captured] = captured,
    };

    private bool Take(long offset, long number, long? captured = 1_000_000) =>
        _state.Take(Key, Headers(offset, number, captured), TestPackets.Motion((int)number));
}
