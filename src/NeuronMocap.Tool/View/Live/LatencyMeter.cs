using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Live;

/// <summary>The mean time from the receipt of a frame to its message, for each performer since the last question. Thread-safe.</summary>
internal sealed class LatencyMeter
{
    private readonly Lock _lock = new();
    private readonly Dictionary<PerformerKey, (TimeSpan Sum, int Count)> _sums = [];

    public void Add(PerformerKey key, TimeSpan latency)
    {
        lock (_lock)
        {
            (TimeSpan sum, int count) = _sums.GetValueOrDefault(key);
            _sums[key] = (sum + latency, count + 1);
        }
    }

    /// <summary>Takes the mean values, in milliseconds, and starts again.</summary>
    public IReadOnlyDictionary<PerformerKey, double> Take()
    {
        lock (_lock)
        {
            Dictionary<PerformerKey, double> means = _sums.ToDictionary(
                static pair => pair.Key, static pair => pair.Value.Sum.TotalMilliseconds / pair.Value.Count);
            _sums.Clear();
            return means;
        }
    }
}
