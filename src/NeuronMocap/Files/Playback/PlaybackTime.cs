using System.Diagnostics;

namespace NeuronMocap.Recording;

// Supplies the time of a playback and waits for it. Tests replace it.
internal class PlaybackTime
{
    // Every wait ends with a spin of 0.5 to 1.5 ms. No wait that is available on all .NET targets is shorter than a millisecond.
    private const int SpinsBetweenLooks = 20;

    // A thread never wakes early. It usually wakes 0.1 ms late, and occasionally 0.5 ms.
    private static readonly long Margin = Stopwatch.Frequency / 2000;

    public static PlaybackTime Real { get; } = new();

    public virtual long Now => Stopwatch.GetTimestamp();

    // Called with the gate held; the wait releases it. Returns at the instant, when the gate is pulsed, or earlier. The caller must check again.
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
