using System.Diagnostics;

namespace NeuronMocap.Recording;

// How a playback knows the time and waits for it. Replaced by tests.
internal class PlaybackTime
{
    // Spinning ends half a millisecond to one and a half of every wait, and no more: nothing that .NET has everywhere waits for less than a millisecond.
    private const int SpinsBetweenLooks = 20;

    // A thread is never woken early, usually late by a tenth of a millisecond, and now and then by half of one.
    private static readonly long Margin = Stopwatch.Frequency / 2000;

    public static PlaybackTime Real { get; } = new();

    public virtual long Now => Stopwatch.GetTimestamp();

    // Under the gate, which is let go meanwhile. Returns at the instant, when the gate is pulsed, or before: whoever waits looks again.
    public virtual void Wait(object gate, long instant)
    {
        // Rounded down.
        long milliseconds = (instant - Stopwatch.GetTimestamp() - Margin) * 1000 / Stopwatch.Frequency;
        if (milliseconds > 0)
        {
            Monitor.Wait(gate, (int)Math.Min(milliseconds, int.MaxValue));
            return;
        }

        Monitor.Exit(gate);
        try
        {
            while (Stopwatch.GetTimestamp() < instant)
                Thread.SpinWait(SpinsBetweenLooks);
        }
        finally
        {
            Monitor.Enter(gate);
        }
    }
}
