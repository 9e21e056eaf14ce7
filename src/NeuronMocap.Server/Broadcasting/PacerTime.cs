using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

// The clock of a pacer: gets the time and waits. Tests replace it.
internal class PacerTime
{
    // Milliseconds. A stop takes no longer because of it than anyone notices.
    private const int LongestSleep = 20;

    public static PacerTime Real { get; } = new();

    // Time in ticks of Stopwatch.
    public virtual long Now => Stopwatch.GetTimestamp();

    // Call it under the gate, which is released during the wait. It returns after the time or when the gate is pulsed. It may also return earlier, so
    // callers check again. A pulse does not end a short wait: a sleep costs a third less processor time than a wait for a pulse.
    public virtual void Wait(object gate, int milliseconds)
    {
        if (milliseconds > LongestSleep)
        {
            Monitor.Wait(gate, milliseconds);
            return;
        }

        Monitor.Exit(gate);
        try
        {
            Thread.Sleep(milliseconds);
        }
        finally
        {
            Monitor.Enter(gate);
        }
    }
}
