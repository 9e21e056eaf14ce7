using System.Diagnostics;

namespace NeuronMocap.Recording;

// Converts Stopwatch timestamps to the time since the start of a recording, exact to 100 ns.
internal sealed class RecordingClock
{
    private readonly long _start = Now;

    public static long Now => Stopwatch.GetTimestamp();

    public DateTimeOffset StartTime { get; } = DateTimeOffset.UtcNow;

    // Timestamps before the start count as the start.
    public TimeSpan TimeOf(long timestamp) => Between(_start, Math.Max(_start, timestamp));

    public static TimeSpan Between(long start, long end)
    {
        long seconds = (end - start) / Stopwatch.Frequency;
        long rest = (end - start) % Stopwatch.Frequency;
        return new TimeSpan((seconds * TimeSpan.TicksPerSecond) + (rest * TimeSpan.TicksPerSecond / Stopwatch.Frequency));
    }
}
