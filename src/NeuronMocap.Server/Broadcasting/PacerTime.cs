using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

// How a pacer knows the time and waits for it. Replaced by tests.
internal class PacerTime
{
    public static PacerTime Real { get; } = new();

    // Ticks of Stopwatch.
    public virtual long Now => Stopwatch.GetTimestamp();

    // Under the gate, which is let go meanwhile. Returns after the time, when the gate is pulsed, or before: whoever waits looks again.
    public virtual void Wait(object gate, int milliseconds) => Monitor.Wait(gate, milliseconds);
}
