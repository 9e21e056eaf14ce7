using System.Diagnostics;

namespace NeuronMocap.Recording;

// Times of a recording on the clock of Stopwatch.
internal static class RecordedTime
{
    public static long ToTimestamp(TimeSpan time) => ToTimestamp(time, Stopwatch.Frequency);

    // Rounds, because the product can be a little too small. At 10 MHz, as on Windows, one time of twenty would lose a tick.
    public static long ToTimestamp(TimeSpan time, long frequency) => ToTicks(Math.Round(time.TotalSeconds * frequency));

    // Without the part behind the point. A number that a long cannot hold becomes the nearest one: runtimes differ in what a cast makes of it.
    public static long ToTicks(double number) => number switch
    {
        >= long.MaxValue => long.MaxValue,
        <= long.MinValue => long.MinValue,
        _ => (long)number,
    };

    // The sum, or the nearest number that a long can hold.
    public static long Add(long ticks, long more)
    {
        long sum = unchecked(ticks + more);
        if (((ticks ^ sum) & (more ^ sum)) >= 0)
            return sum;

        return more < 0 ? long.MinValue : long.MaxValue;
    }
}
