using System.Diagnostics;

namespace NeuronMocap.Recording;

// From the timestamps of Stopwatch to the time since a recording began, exact to 100 ns.
internal sealed class RecordingClock
{
    private readonly long _start = Now;

    public static long Now => Stopwatch.GetTimestamp();

    public DateTimeOffset StartTime { get; } = DateTimeOffset.UtcNow;

    // What was stamped before the start counts as the start.
    public TimeSpan TimeOf(long timestamp) => Between(_start, Math.Max(_start, timestamp));

    public static TimeSpan Between(long start, long end)
    {
        long seconds = (end - start) / Stopwatch.Frequency;
        long rest = (end - start) % Stopwatch.Frequency;
        return new TimeSpan((seconds * TimeSpan.TicksPerSecond) + (rest * TimeSpan.TicksPerSecond / Stopwatch.Frequency));
    }
}
