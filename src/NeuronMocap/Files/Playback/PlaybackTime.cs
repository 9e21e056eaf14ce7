using System.Diagnostics;

namespace NeuronMocap.Recording;

// Supplies the time of a playback and waits for it. Tests replace it.
internal class PlaybackTime
{
    // Every wait ends with a spin: 0.5 to 1.5 ms where no wait is shorter than a millisecond, and about 0.05 ms with PreciseSleep.
    private const int SpinsBetweenLooks = 20;

    // A thread never wakes early. It usually wakes 0.1 ms late, and occasionally 0.5 ms.
    private static readonly long Margin = Stopwatch.Frequency / 2000;

    private static readonly long PreciseMargin = Stopwatch.Frequency / 8000;

    // A pulse does not end a precise sleep, so it is never longer than this.
    private static readonly long LongestSleep = Stopwatch.Frequency / 50;

    public static PlaybackTime Real { get; } = new();

    public virtual long Now => Stopwatch.GetTimestamp();

    // Called with the gate held; the wait releases it. Returns at the instant, when the gate is pulsed, or earlier. The caller must check again.
    public virtual void Wait(object gate, long instant)
    {
        long rest = instant - Stopwatch.GetTimestamp();
        bool isShort = PreciseSleep.IsAvailable && rest <= LongestSleep;

        // Rounded down.
        long milliseconds = (rest - Margin) * 1000 / Stopwatch.Frequency;
        if (milliseconds > 0 && !isShort)
        {
            Monitor.Wait(gate, (int)Math.Min(milliseconds, int.MaxValue));
            return;
        }

        Monitor.Exit(gate);
        try
        {
            if (isShort && rest > PreciseMargin)
            {
                PreciseSleep.Sleep(rest - PreciseMargin);
                return;
            }

            while (Stopwatch.GetTimestamp() < instant)
                Thread.SpinWait(SpinsBetweenLooks);
        }
        finally
        {
            Monitor.Enter(gate);
        }
    }
}
