using System.Globalization;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Telemetry;

// Turns what a reader counts into events for a log. States are told as they change, on the thread that tells them; losses are found by a timer
// that looks at the counters, so that the receive thread has nothing to do with them, however many there are.
internal sealed class EventReporter(string name, IReaderFigures figures, Action<ReaderEvent> report)
{
    // For a report that another thread is just making.
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(0.1);

    private static readonly SkipReason[] SkipReasons =
        [SkipReason.NoTokens, SkipReason.UnknownVersion, SkipReason.TooLarge, SkipReason.Incomplete];

    private readonly object _lock = new();
    private readonly HashSet<(ConnectionState State, ConnectionReason Reason)> _told = [];
    private readonly Dictionary<(ReaderEventId Id, string? Subject), ThrottledCount> _counts = [];
    private volatile Exception? _failure;
    private bool _ended;

    // One thread at a time, in the order of the changes.
    public void OnStatus(ConnectionStatus status) =>
        report(new ReaderEvent((ReaderEventId)status.State, LevelOf(status), name, status.Message) { Status = status });

    // Any thread.
    public void OnFailure(Exception exception) => _failure = exception;

    // Timer. A report may take longer than the timer's period: then the next one is left out.
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
            Monitor.Exit(_lock);
        }
    }

    // Once, when nothing more is received: what no report told yet.
    public void End(long now)
    {
        if (!Monitor.TryEnter(_lock, Patience))
            return;

        try
        {
            _ended = true;
            Report(now, force: true);
        }
        finally
        {
            Monitor.Exit(_lock);
        }
    }

    private void Report(long now, bool force)
    {
        ReaderStatistics statistics = figures.GetStatistics();
        long lostFrames = statistics.Lost - (force ? 0 : figures.UnsettledLoss);
        if (Take(ReaderEventId.FramesLost, null, lostFrames, now, force) is { Count: > 0 } lost)
            report(lost with { Message = Text($"{lost.Count} frames that the server sent did not arrive; {lost.Total} in all, in {statistics.Gaps} gaps.") });

        foreach (ConsumerStatistics consumer in figures.GetConsumers())
        {
            if (Take(ReaderEventId.FramesDropped, consumer.Name, consumer.Dropped, now, force) is { Count: > 0 } dropped)
            {
                report(dropped with
                {
                    Message = Text($"The queue '{consumer.Name}' was full and dropped {dropped.Count} frames; {dropped.Total} in all. ")
                        + "Pump it more often, or give it a larger capacity.",
                });
            }
        }

        foreach (SkipReason reason in SkipReasons)
        {
            if (Take(ReaderEventId.BytesSkipped, reason.ToString(), figures.GetSkipped(reason), now, force) is { Count: > 0 } skipped)
                report(skipped with { Message = Text($"{skipped.Count} bytes belong to no packet ({Describe(reason)}); {skipped.Total} in all.") });
        }

        if (Take(ReaderEventId.HandlerFailed, null, statistics.CallbackFailures, now, force) is { Count: > 0 } failed)
        {
            Exception? failure = _failure;
            report(failed with
            {
                Level = ReaderEventLevel.Error,
                Exception = failure,
                Message = Text($"Handlers threw {failed.Count} exceptions, {failed.Total} in all; the newest: {failure?.Message}"),
            });
        }
    }

    private ReaderEvent Take(ReaderEventId id, string? subject, long total, long now, bool force)
    {
        if (!_counts.TryGetValue((id, subject), out ThrottledCount? count))
            _counts.Add((id, subject), count = new ThrottledCount());

        long growth = count.Take(total, now, force);
        return new ReaderEvent(id, ReaderEventLevel.Warning, name, string.Empty) { Subject = subject, Count = growth, Total = total };
    }

    // A server that is down for an hour is one warning, not one for every attempt: a problem is told again when frames came in between.
    private ReaderEventLevel LevelOf(in ConnectionStatus status)
    {
        if (status.State == ConnectionState.Receiving)
            _told.Clear();

        bool isNew = _told.Add((status.State, status.Reason));
        return status.State switch
        {
            ConnectionState.Receiving => ReaderEventLevel.Information,
            ConnectionState.Connected when isNew => ReaderEventLevel.Information,
            ConnectionState.Silent or ConnectionState.Waiting when isNew => ReaderEventLevel.Warning,
            ConnectionState.Stopped => status.Reason is ConnectionReason.Requested ? ReaderEventLevel.Information : ReaderEventLevel.Error,
            _ => ReaderEventLevel.Debug,
        };
    }

    private static string Describe(SkipReason reason) => reason switch
    {
        SkipReason.UnknownVersion => "a data version other than 1.0 and 1.1",
        SkipReason.TooLarge => "more values than MaxValues allows",
        SkipReason.Incomplete => "packets whose rest never came",
        _ => "no tokens of a packet",
    };

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
