using System.Diagnostics;

namespace NeuronMocap.Json;

/// <summary>The times in the lines of --json: seconds since the start on a steady clock, and the same instant in UTC.</summary>
/// <param name="start">The start, in ticks of <see cref="Stopwatch"/>.</param>
/// <param name="utc">The same instant, in UTC.</param>
internal sealed class JsonClock(long start, DateTime utc)
{
    /// <summary>Creates a clock that starts now.</summary>
    public JsonClock()
        : this(Stopwatch.GetTimestamp(), DateTime.UtcNow)
    {
    }

    public long Start => start;

    /// <summary>Gets the seconds from the start to an instant. Earlier instants give 0.</summary>
    public double SecondsTo(long timestamp) => Math.Max(Stopwatch.GetElapsedTime(start, timestamp).TotalSeconds, 0);

    /// <summary>Gets an instant in UTC. Changes of the system clock do not affect it.</summary>
    public DateTime UtcOf(long timestamp) => utc.AddSeconds(SecondsTo(timestamp));
}
