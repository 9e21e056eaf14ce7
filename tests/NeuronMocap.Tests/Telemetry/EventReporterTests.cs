using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Telemetry;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Telemetry;

public sealed class EventReporterTests
{
    private readonly Figures _figures = new();
    private readonly List<ReaderEvent> _events = [];
    private readonly EventReporter _reporter;

    public EventReporterTests() => _reporter = new EventReporter("studio", _figures, _events.Add);

    [Fact]
    public void The_first_loss_is_told_at_once_and_what_follows_once_in_ten_seconds()
    {
        for (int tick = 0; tick < 60; tick++)
        {
            _figures.Statistics = _figures.Statistics with { Lost = tick, Gaps = tick };
            _reporter.Check(At(tick / 2.0));
        }

        Assert.Equal([(1, 1), (20, 21), (20, 41)], _events.Select(reported => ((int)reported.Count, (int)reported.Total)));
        Assert.All(_events, reported => Assert.Equal((ReaderEventId.FramesLost, ReaderEventLevel.Warning, "studio"), (reported.Id, reported.Level, reported.Reader)));
        Assert.Contains("20 frames", _events[1].Message, StringComparison.Ordinal);

        _reporter.End(At(30));
        Assert.Equal((18, 59), (_events[^1].Count, _events[^1].Total));
        _figures.Statistics = _figures.Statistics with { Lost = 100 };
        _reporter.Check(At(100));
        Assert.Equal(4, _events.Count);
    }

    [Fact]
    public void What_may_be_a_reduced_frequency_is_no_loss_yet()
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
    public void A_server_that_is_down_for_long_is_one_warning()
    {
        for (int attempt = 1; attempt < 100; attempt++)
        {
            Tell(ConnectionState.Connecting);
            Tell(ConnectionState.Waiting, ConnectionReason.Refused);
        }

        Tell(ConnectionState.Connected);
        Tell(ConnectionState.Receiving);
        Tell(ConnectionState.Waiting, ConnectionReason.Refused);
        Assert.Equal(
            [
                (ReaderEventId.Waiting, ReaderEventLevel.Warning), (ReaderEventId.Connected, ReaderEventLevel.Information),
                (ReaderEventId.Receiving, ReaderEventLevel.Information), (ReaderEventId.Waiting, ReaderEventLevel.Warning),
            ],
            _events.Where(reported => reported.Level > ReaderEventLevel.Debug).Select(reported => (reported.Id, reported.Level)));
    }

    [Theory]
    [InlineData(ConnectionReason.Requested, ReaderEventLevel.Information)]
    [InlineData(ConnectionReason.Refused, ReaderEventLevel.Error)]
    public void An_end_that_nobody_asked_for_is_an_error(ConnectionReason reason, ReaderEventLevel level)
    {
        Tell(ConnectionState.Stopped, reason);
        Assert.Equal((ReaderEventId.Stopped, level), (_events[0].Id, _events[0].Level));
    }

    [Fact]
    public void Every_state_has_an_event_of_its_name()
    {
        foreach (ConnectionState state in Enum.GetValues<ConnectionState>().Where(state => state != ConnectionState.Created))
            Assert.Equal(state.ToString(), ((ReaderEventId)state).ToString());
    }

    [Fact]
    public async Task A_report_that_hangs_holds_up_neither_the_next_look_nor_the_end()
    {
        using var release = new ManualResetEventSlim();
        using var reporting = new ManualResetEventSlim();
        var reporter = new EventReporter("studio", _figures, _ =>
        {
            reporting.Set();
            release.Wait(Limits.Unexpected);
        });
        _figures.Statistics = new ReaderStatistics { Lost = 1 };
        Task hanging = Task.Run(() => reporter.Check(At(0)));
        Assert.True(reporting.Wait(Limits.Unexpected));
        reporter.Check(At(20));
        reporter.End(At(20));
        Assert.False(hanging.IsCompleted);
        release.Set();
        await hanging.Soon();
    }

    private static long At(double seconds) => (long)((1000 + seconds) * Stopwatch.Frequency);

    private void Tell(ConnectionState state, ConnectionReason reason = ConnectionReason.None) =>
        _reporter.OnStatus(new ConnectionStatus(state, reason, "A message."));

    private sealed class Figures : IReaderFigures
    {
        public List<ConsumerStatistics> Consumers { get; } = [];

        public Dictionary<SkipReason, long> Skipped { get; } = [];

        public ReaderStatistics Statistics { get; set; }

        public ConnectionState State => ConnectionState.Receiving;

        public long UnsettledLoss { get; set; }

        public ReaderStatistics GetStatistics() => Statistics;

        public IReadOnlyList<ConsumerStatistics> GetConsumers() => Consumers;

        public long GetSkipped(SkipReason reason) => Skipped.GetValueOrDefault(reason);
    }
}
