using System.Diagnostics;

namespace NeuronMocap.Playback;

// How a playback knows the time and waits for it. Replaced by tests.
internal class PlaybackTime
{
    // Spinning ends up to a millisecond of every wait, and no more: nothing that .NET has everywhere waits for less than a millisecond.
    private const int SpinsBetweenLooks = 20;

    public static PlaybackTime Real { get; } = new();

    public virtual long Now => Stopwatch.GetTimestamp();

    // Under the gate, which is let go meanwhile. Returns at the instant, when the gate is pulsed, or before: whoever waits looks again.
    public virtual void Wait(object gate, long instant)
    {
        // Rounded down: a thread is never woken early, and usually late by a tenth of a millisecond.
        long milliseconds = (instant - Stopwatch.GetTimestamp()) * 1000 / Stopwatch.Frequency;
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
