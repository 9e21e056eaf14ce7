using System.Diagnostics;

namespace NeuronMocap.Telemetry;

// Decides when the growth of a counter deserves a report: the first growth at once, later growth in one report every ten seconds.
internal sealed class ThrottledCount
{
    private static readonly long Period = 10 * Stopwatch.Frequency;

    private long _reported;
    private long _lastReport;
    private bool _hasReported;

    // Returns the growth to report now, or 0. force: this is the last chance.
    public long Take(long total, long now, bool force)
    {
        long growth = total - _reported;
        if (growth <= 0 || (_hasReported && !force && now - _lastReport < Period))
            return 0;

        _reported = total;
        _lastReport = now;
        _hasReported = true;
        return growth;
    }
}
