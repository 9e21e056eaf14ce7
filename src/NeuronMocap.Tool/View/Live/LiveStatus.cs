using System.Diagnostics;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.Watch.Live;

namespace NeuronMocap.Tool.View.Live;

/// <summary>Describes the state of the stream for the pages. Thread-safe.</summary>
internal sealed class LiveStatus(NeuronReader reader, string source, LivePerformers performers, WebSocketBroadcaster motion, LatencyMeter latency)
{
    private readonly Lock _lock = new();
    private readonly RateMeter _bytes = new();
    private IReadOnlyDictionary<PerformerKey, double> _latencies = new Dictionary<PerformerKey, double>();

    /// <summary>Takes the figures of this moment. Called once a second.</summary>
    public void Update()
    {
        lock (_lock)
        {
            _bytes.Add(Stopwatch.GetTimestamp(), reader.GetStatistics().BytesReceived);
            _latencies = latency.Take();
        }
    }

    public StatusMessage Describe()
    {
        ConnectionStatus status = reader.Status;
        ReaderStatistics statistics = reader.GetStatistics();
        IReadOnlyList<AvatarStatistics> avatars = reader.GetAvatarStatistics();
        (string words, string advice) = Explain(status, avatars);
        WebSocketBroadcasterStatistics sent = motion.GetStatistics();
        lock (_lock)
        {
            return new StatusMessage(
                status.State.ToString().ToLowerInvariant(),
                words,
                advice,
                status.RemoteEndPoint?.ToString() ?? source,
                [.. avatars.Where(avatar => avatar.Kind == PacketKind.Motion && performers.Find(PerformerKey.Of(avatar)) is not null).Select(Describe)],
                _bytes.PerSecond,
                statistics.Reconnects)
            {
                RetryIn = status.RetryIn is { } delay ? Math.Max((delay - Stopwatch.GetElapsedTime(status.Timestamp)).TotalMilliseconds, 0) : null,
                Dropped = sent.FramesDropped + sent.FramesMissed,
            };
        }
    }

    private (string Words, string Advice) Explain(ConnectionStatus status, IReadOnlyList<AvatarStatistics> avatars)
    {
        if (status.State != ConnectionState.Receiving)
            return (status.Title(), status.Describe());

        bool hasMotion = avatars.Any(static avatar => avatar.Kind == PacketKind.Motion);
        int? values = performers.ValuesWithoutSkeleton;
        if ((!hasMotion || values is not null) && MissingSkeleton.Explain(values, avatars.Count > 0) is { } problem)
            return problem;

        return (status.Title(), status.Reason == ConnectionReason.None ? string.Empty : status.Describe());
    }

    private PerformerFigures Describe(AvatarStatistics avatar)
    {
        var key = PerformerKey.Of(avatar);
        bool isStale = avatar.GetAge(Stopwatch.GetTimestamp()) > TimeSpan.FromSeconds(1);
        return new PerformerFigures(
            key.ToString(),
            isStale ? 0 : Round(avatar.FrameRate, 1),
            _latencies.TryGetValue(key, out double milliseconds) ? Round(milliseconds, 2) : null,
            Round(avatar.Jitter.TotalMilliseconds, 2),
            avatar.Lost,
            avatar.OutOfOrder);
    }

    // JSON has only finite numbers.
    private static double Round(double value, int digits) => double.IsFinite(value) ? Math.Round(value, digits) : 0;
}
