using System.Diagnostics;

namespace NeuronMocap.Recording;

// Times of a recording on the clock of Stopwatch.
internal static class RecordedTime
{
    public static long ToTimestamp(TimeSpan time) => ToTimestamp(time, Stopwatch.Frequency);

    // Rounds, because the product can be a little too small. At 10 MHz, as on Windows, one time of twenty would lose a tick.
    public static long ToTimestamp(TimeSpan time, long frequency) => (long)Math.Round(time.TotalSeconds * frequency);
}
