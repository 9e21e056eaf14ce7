using NeuronMocap.Delivery;
using NeuronMocap.Files;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Transport;
using static System.FormattableString;

namespace NeuronMocap.Telemetry;

// Turns a reader's counters into events for a log. Changes of state are reported at once, on the thread that publishes them. A timer compares the counters
// to find losses, so losses cost the receive thread nothing, however many there are.
internal sealed class EventReporter(string name, IReaderStatistics figures, Action<ReaderEvent> report)
{
    private static readonly (SkipReason Reason, string Name)[] SkipReasons =
    [
        (SkipReason.NoTokens, nameof(SkipReason.NoTokens)),
        (SkipReason.UnknownVersion, nameof(SkipReason.UnknownVersion)),
        (SkipReason.TooLarge, nameof(SkipReason.TooLarge)),
        (SkipReason.Incomplete, nameof(SkipReason.Incomplete)),
        (SkipReason.MalformedLine, nameof(SkipReason.MalformedLine)),
        (SkipReason.AmbiguousName, nameof(SkipReason.AmbiguousName)),
        (SkipReason.TooManySenders, nameof(SkipReason.TooManySenders)),
        (SkipReason.NotCalculation, nameof(SkipReason.NotCalculation)),
        (SkipReason.MissingAvatar, nameof(SkipReason.MissingAvatar)),
    ];

    private readonly object _lock = new();
    private readonly StatusLevels _levels = new();
    private readonly Dictionary<(ReaderEventId Id, string? Subject), ThrottledCount> _counts = [];
    private readonly TaskCompletionSource<bool> _endedCompletion = new();
    private readonly HashSet<IFileOutput> _outputs = [];
    private long _droppedReported;
    private volatile Exception? _failure;
    private volatile bool _ended;

    // How long to wait for a report on another thread: half of the stop timeout, so the last status is still published within it.
    public TimeSpan EndTimeout { get; init; } = TimeSpan.FromSeconds(1);

    // Whether the calling thread is making a report, which means that a handler is calling.
    public bool IsReporting => Monitor.IsEntered(_lock);

    // Completes after the end, when no report runs. Code that awaits it continues without a pool thread.
    public Task Ended => _endedCompletion.Task;

    // One thread at a time, in the order of the changes.
    public void OnStatus(ConnectionStatus status) =>
        report(new ReaderEvent((ReaderEventId)status.State, _levels.LevelOf(status), name, status.Message) { Status = status });

    // Any thread.
    public void OnFailure(Exception exception) => _failure = exception;

    // Called by the timer, and by the thread of an output that has ended. If a report takes longer than the timer's period, the next report is skipped.
    public void Check(long now)
    {
        if (!Monitor.TryEnter(_lock))
            return;

        try
        {
            if (!_ended)
                Report(now, force: false);
        }
        finally
        {
            Leave();
        }
    }

    // Called once, when receiving has ended, to report the rest. A running report is awaited on a separate thread: the calling thread may be that of a
    // handler, and the pool may have no free thread.
    public Task EndAsync(long now)
    {
        _ended = true;
        return TryEnd(now, TimeSpan.Zero)
            ? Task.CompletedTask
            : DedicatedThread.RunAsync("NeuronMocap last report", () => TryEnd(now, EndTimeout), TaskCreationOptions.None);
    }

    private bool TryEnd(long now, TimeSpan timeout)
    {
        if (!Monitor.TryEnter(_lock, timeout))
            return false;

        try
        {
            Report(now, force: true);
        }
        finally
        {
            Leave();
        }

        return true;
    }

    private void Leave()
    {
        Monitor.Exit(_lock);

        // The lock is still held if a handler's Dispose reached the end on the handler's thread.
        if (_ended && !IsReporting)
            _endedCompletion.TrySetResult(true);
    }

    private void Report(long now, bool force)
    {
        try
        {
            // Read before and after the loss: frames that turn out to be a reduced frequency in between are subtracted from both.
            long unsettled = figures.UnsettledLoss;
            ReaderStatistics statistics = figures.GetStatistics();
            unsettled = force ? 0 : Math.Max(unsettled, figures.UnsettledLoss);

            ReportLoss(statistics, unsettled, now, force);
            if (statistics.Dropped > _droppedReported)
                ReportDropped(now, force);

            ReportSkipped(now, force);
            ReportFailures(statistics, now, force);
            foreach (IFileOutput output in figures.Outputs)
                ReportOutput(output, now, force);
        }
        catch (Exception)
        {
            // The system is out of memory, or the Message of a handler's exception throws. Neither may end the process; the statistics contain the counts.
        }
    }

    private void ReportLoss(in ReaderStatistics statistics, long unsettled, long now, bool force)
    {
        if (Take(ReaderEventId.FramesLost, null, statistics.Lost - unsettled, now, force) is not { Count: > 0 } lost)
            return;

        string gaps = CountedNoun.Of(statistics.Gaps, "gap");
        report(lost with { Message = Invariant($"{CountedNoun.Of(lost.Count, "frame")} that the server sent did not arrive; {lost.Total} in all, in {gaps}.") });
    }

    private void ReportDropped(long now, bool force)
    {
        foreach (ConsumerStatistics consumer in figures.GetConsumers())
        {
            // An export reports its own losses.
            if (string.Equals(consumer.Name, NeuronReader.ExportQueueName, StringComparison.Ordinal))
                continue;
            if (Take(ReaderEventId.FramesDropped, consumer.Name, consumer.Dropped, now, force) is not { Count: > 0 } dropped)
                continue;

            _droppedReported += dropped.Count;
            report(dropped with
            {
                Message = Invariant($"The queue '{consumer.Name}' was full and dropped {CountedNoun.Of(dropped.Count, "frame")}; {dropped.Total} in all. ")
                    + "Pump it more often, or give it a larger capacity.",
            });
        }
    }

    private void ReportSkipped(long now, bool force)
    {
        foreach ((SkipReason reason, string subject) in SkipReasons)
        {
            if (Take(ReaderEventId.BytesSkipped, subject, figures.GetSkipped(reason), now, force) is { Count: > 0 } skipped)
                report(skipped with { Message = Invariant($"{CountedNoun.Of(skipped.Count, "byte")} outside packets ({Describe(reason)}); {skipped.Total} in all.") });
        }
    }

    private void ReportFailures(in ReaderStatistics statistics, long now, bool force)
    {
        if (Take(ReaderEventId.CallbackFailed, null, statistics.CallbackFailures, now, force) is not { Count: > 0 } failed)
            return;

        Exception? failure = _failure;
        report(failed with
        {
            Level = ReaderEventLevel.Error,
            Exception = failure,
            Message = Invariant($"Handlers threw {CountedNoun.Of(failed.Count, "exception")}, {failed.Total} in all; the newest: {failure?.Message}"),
        });
    }

    private void ReportOutput(IFileOutput output, long now, bool force)
    {
        if (_ended && !force)
            return;

        OutputIds ids = output is StreamRecorder ? OutputIds.Recording : OutputIds.Export;
        bool hasEnded = output.Completion.IsCompleted;
        var news = new ReaderEvent(ids.Started, ReaderEventLevel.Information, name, output.DescribeStart()) { Subject = output.Path };
        if (_outputs.Add(output))
            report(news);

        Exception? failure = hasEnded ? output.Failure : null;
        if (failure is null && Take(ids.Incomplete, output.Path, output.Lost, now, force || hasEnded) is { Count: > 0 } lost)
            report(lost with { Message = output.DescribeLoss(lost.Count) });
        if (Take(ReaderEventId.RecordingFileKept, output.Path, output.UndeletedFiles, now, force || hasEnded) is { Count: > 0 } kept)
            report(kept with { Message = output.DescribeUndeleted() });
        if (!hasEnded)
            return;

        _counts.Remove((ids.Incomplete, output.Path));
        _counts.Remove((ReaderEventId.RecordingFileKept, output.Path));
        _outputs.Remove(output);
        figures.Forget(output);
        news = news with { Id = ids.Stopped, Message = output.DescribeEnd() };
        report(failure is null ? news : news with { Id = ids.Failed, Level = ReaderEventLevel.Error, Exception = failure, Count = output.Lost, Total = output.Lost });
    }

    // Returns an empty event after the end, because the last report includes the rest.
    private ReaderEvent Take(ReaderEventId id, string? subject, long total, long now, bool force)
    {
        if (_ended && !force)
            return default;

        if (!_counts.TryGetValue((id, subject), out ThrottledCount? count))
            _counts.Add((id, subject), count = new ThrottledCount());

        long growth = count.Take(total, now, force);
        return new ReaderEvent(id, ReaderEventLevel.Warning, name, string.Empty) { Subject = subject, Count = growth, Total = total };
    }

    private static string Describe(SkipReason reason) => reason switch
    {
        SkipReason.UnknownVersion => "a data version other than 1.0 and 1.1",
        SkipReason.TooLarge => "more values than MaxValues allows",
        SkipReason.Incomplete => "packets whose rest never arrived",
        SkipReason.MalformedLine => "lines of text that are not frames of 59 bones",
        SkipReason.AmbiguousName => "lines of text whose avatar name contains spaces and numbers",
        SkipReason.TooManySenders => "more than 64 senders at a time",
        SkipReason.NotCalculation => "motion data on the port of calculation data",
        SkipReason.MissingAvatar => "lines of text without the avatar's number and name",
        _ => "no tokens of a packet",
    };

    private sealed record OutputIds(ReaderEventId Started, ReaderEventId Stopped, ReaderEventId Incomplete, ReaderEventId Failed)
    {
        public static readonly OutputIds Recording =
            new(ReaderEventId.RecordingStarted, ReaderEventId.RecordingStopped, ReaderEventId.RecordingIncomplete, ReaderEventId.RecordingFailed);

        public static readonly OutputIds Export =
            new(ReaderEventId.ExportStarted, ReaderEventId.ExportStopped, ReaderEventId.ExportIncomplete, ReaderEventId.ExportFailed);
    }
}
