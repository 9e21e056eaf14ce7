using System.Diagnostics;

namespace NeuronMocap.Tool.Output;

/// <summary>The times of the lines of --json: seconds since the start on a clock that never jumps, and the same instant of the calendar.</summary>
/// <param name="start">The start, in ticks of <see cref="Stopwatch"/>.</param>
/// <param name="utc">The same instant, in UTC.</param>
internal sealed class JsonClock(long start, DateTime utc)
{
    /// <summary>Begins now.</summary>
    public JsonClock()
        : this(Stopwatch.GetTimestamp(), DateTime.UtcNow)
    {
    }

    public long Start => start;

    /// <summary>Seconds from the start to an instant; what happened before it is 0.</summary>
    public double SecondsTo(long timestamp) => Math.Max(Stopwatch.GetElapsedTime(start, timestamp).TotalSeconds, 0);

    /// <summary>The instant in UTC. A clock that somebody sets meanwhile does not change it.</summary>
    public DateTime UtcOf(long timestamp) => utc.AddSeconds(SecondsTo(timestamp));
}
