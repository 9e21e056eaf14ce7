using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

// The clock of a pacer: gets the time and waits. Tests replace it.
internal class PacerTime
{
    public static PacerTime Real { get; } = new();

    // Time in ticks of Stopwatch.
    public virtual long Now => Stopwatch.GetTimestamp();

    // Call it under the gate, which is released during the wait. It returns after the time or when the gate is pulsed. It may also return earlier, so
    // callers check again.
    public virtual void Wait(object gate, int milliseconds) => Monitor.Wait(gate, milliseconds);
}
