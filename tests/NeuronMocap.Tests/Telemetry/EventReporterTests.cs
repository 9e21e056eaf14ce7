using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Files;
using NeuronMocap.Protocol;
using NeuronMocap.Telemetry;

namespace NeuronMocap.Tests.Telemetry;

public sealed class EventReporterTests
{
    private readonly Figures _figures = new();
    private readonly List<ReaderEvent> _events = [];
    private readonly EventReporter _reporter;

    public EventReporterTests() => _reporter = new EventReporter("studio", _figures, _events.Add);

    [Fact]
    public async Task The_first_loss_is_reported_at_once_and_others_every_ten_seconds()
    {
        for (int tick = 0; tick < 60; tick++)
        {
            _figures.Statistics = _figures.Statistics with { Lost = tick, Gaps = tick };
            _reporter.Check(At(tick / 2.0));
        }

        Assert.Equal([(1, 1), (20, 21), (20, 41)], _events.Select(reported => ((int)reported.Count, (int)reported.Total)));
        Assert.All(_events, reported => Assert.Equal((ReaderEventId.FramesLost, ReaderEventLevel.Warning, "studio"), (reported.Id, reported.Level, reported.Reader)));
        Assert.Contains("20 frames", _events[1].Message, StringComparison.Ordinal);

        await _reporter.EndAsync(At(30)).Soon();
        Assert.Equal((18, 59), (_events[^1].Count, _events[^1].Total));
        _figures.Statistics = _figures.Statistics with { Lost = 100 };
        _reporter.Check(At(100));
        Assert.Equal(4, _events.Count);
    }

    [Fact]
    public void A_possible_reduced_frequency_is_not_reported_as_loss()
    {
        _figures.Statistics = new ReaderStatistics { Lost = 12 };
        _figures.UnsettledLoss = 12;
        _reporter.Check(At(0));
        Assert.Empty(_events);
        _figures.UnsettledLoss = 0;
        _reporter.Check(At(1));
        Assert.Equal(12, Assert.Single(_events).Count);
    }

    [Fact]
    public void Each_queue_and_each_kind_of_garbage_has_its_own_reports()
    {
        _figures.Consumers.AddRange([new("draw", 3, 0), new("record", 0, 0)]);
        _figures.Skipped[SkipReason.TooLarge] = 64;
        _reporter.Check(At(0));
        _figures.Consumers[1] = new("record", 9, 0);
        _figures.Skipped[SkipReason.NoTokens] = 7;
        _reporter.Check(At(1));

        Assert.Equal(
            [
                (ReaderEventId.FramesDropped, "draw", 3), (ReaderEventId.BytesSkipped, "TooLarge", 64),
                (ReaderEventId.FramesDropped, "record", 9), (ReaderEventId.BytesSkipped, "NoTokens", 7),
            ],
            _events.Select(reported => (reported.Id, reported.Subject!, (int)reported.Count)));
    }

    [Fact]
    public void Failures_of_handlers_carry_the_newest_exception()
    {
        var failure = new InvalidOperationException("no disk");
        _reporter.OnFailure(failure);
        _figures.Statistics = new ReaderStatistics { CallbackFailures = 5 };
        _reporter.Check(At(0));
        ReaderEvent reported = Assert.Single(_events);
        Assert.Same(failure, reported.Exception);
        Assert.Equal(ReaderEventLevel.Error, reported.Level);
        Assert.Contains("no disk", reported.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Every_state_has_an_event_of_its_name()
    {
        foreach (ConnectionState state in Enum.GetValues<ConnectionState>().Where(state => state != ConnectionState.Created))
            Assert.Equal(state.ToString(), ((ReaderEventId)state).ToString());
    }

    [Fact]
    public async Task A_hanging_report_blocks_neither_polling_nor_the_end()
    {
        using var release = new ManualResetEventSlim();
        using var reporting = new ManualResetEventSlim();
        int told = 0;
        var reporter = new EventReporter("studio", _figures, _ =>
        {
            told++;
            reporting.Set();
            release.Wait(Limits.Unexpected);
        });
        _figures.Statistics = new ReaderStatistics { Lost = 1, CallbackFailures = 1 };
        Task hanging = Task.Run(() => reporter.Check(At(0)));
        Assert.True(reporting.Wait(Limits.Unexpected));
        reporter.Check(At(20));
        await reporter.EndAsync(At(20)).Soon();
        Assert.False(hanging.IsCompleted);
        Assert.False(reporter.Ended.IsCompleted);
        release.Set();
        await hanging.Soon();
        await reporter.Ended.Soon();
        Assert.Equal(1, told);
    }

    [Fact]
    public async Task The_end_waits_for_a_running_report_and_reports_the_rest()
    {
        using var release = new ManualResetEventSlim();
        using var reporting = new ManualResetEventSlim();
        var reporter = new EventReporter("studio", _figures, reported =>
        {
            _events.Add(reported);
            reporting.Set();
            release.Wait(Limits.Unexpected);
        })
        {
            EndTimeout = Limits.Unexpected,
        };
        _figures.Statistics = new ReaderStatistics { Lost = 1, CallbackFailures = 1 };
        Task running = Task.Run(() => reporter.Check(At(0)));
        Assert.True(reporting.Wait(Limits.Unexpected));
        Task end = reporter.EndAsync(At(1));
        Assert.False(end.IsCompleted);
        release.Set();
        await Task.WhenAll(running, end, reporter.Ended).Soon();
        Assert.Equal([ReaderEventId.FramesLost, ReaderEventId.CallbackFailed], _events.Select(reported => reported.Id));
    }

    [Fact]
    public void A_frequency_that_is_found_while_polling_is_no_loss()
    {
        _figures.Statistics = new ReaderStatistics { Lost = 12 };
        _figures.UnsettledLoss = 12;

        // The reader's receive thread runs between the two readings: the first sees the loss, and the second sees nothing unsettled.
        _figures.Read = () => _figures.UnsettledLoss = 0;
        _reporter.Check(At(0));
        Assert.Empty(_events);
    }

    [Fact]
    public void Singular_and_plural_are_correct()
    {
        _figures.Consumers.Add(new("draw", 1, 0));
        _figures.Skipped[SkipReason.NoTokens] = 1;
        _figures.Statistics = new ReaderStatistics { Lost = 1, Gaps = 1, CallbackFailures = 1 };
        _reporter.Check(At(0));
        Assert.Equal(4, _events.Count);
        Assert.All(_events, reported => Assert.DoesNotMatch("1 [a-z]+s[ ,.;]", reported.Message));
    }

    [Fact]
    public async Task An_exception_with_a_throwing_message_is_handled()
    {
        _reporter.OnFailure(new Unspeakable());
        _figures.Statistics = new ReaderStatistics { CallbackFailures = 1 };
        _reporter.Check(At(0));
        _figures.Statistics = new ReaderStatistics { CallbackFailures = 2, Lost = 1 };
        await _reporter.EndAsync(At(1)).Soon();
        await _reporter.Ended.Soon();
        Assert.Equal(ReaderEventId.FramesLost, Assert.Single(_events).Id);
    }

    [Fact]
    public void Polling_without_news_allocates_nothing()
    {
        _figures.Consumers.Add(new("draw", 3, 0));
        _figures.Skipped[SkipReason.NoTokens] = 7;
        _figures.Statistics = new ReaderStatistics { Lost = 1, Gaps = 1, CallbackFailures = 1 };
        _reporter.Check(At(0));
        int lists = _figures.Lists;
        Allocations.AssertNone(() => _reporter.Check(At(0)));
        Assert.Equal(lists, _figures.Lists);
        Assert.Equal(4, _events.Count);
    }

    private static long At(double seconds) => (long)((1000 + seconds) * Stopwatch.Frequency);

    private sealed class Unspeakable : Exception
    {
        public override string Message => throw new InvalidOperationException("No words.");
    }

    private sealed class Figures : IReaderStatistics
    {
        public List<ConsumerStatistics> Consumers { get; } = [];

        public Dictionary<SkipReason, long> Skipped { get; } = [];

        public ReaderStatistics Statistics { get; set; }

        public ConnectionState State => ConnectionState.Receiving;

        public int? ReceiveBufferSize => null;

        public long UnsettledLoss { get; set; }

        // Runs between two readings.
        public Action? Read { get; set; }

        public int Lists { get; private set; }

        public ReaderStatistics GetStatistics()
        {
            long dropped = 0;
            foreach (ConsumerStatistics consumer in Consumers)
                dropped += consumer.Dropped;

            ReaderStatistics statistics = Statistics with { Dropped = dropped };
            Read?.Invoke();
            return statistics;
        }

        public IReadOnlyList<ConsumerStatistics> GetConsumers()
        {
            Lists++;
            return Consumers;
        }

        public long GetSkipped(SkipReason reason) => Skipped.GetValueOrDefault(reason);

        public IReadOnlyList<IFileOutput> Outputs => [];

        public void Forget(IFileOutput output)
        {
        }
    }
}
