namespace NeuronMocap;

// .NET Framework and Mono, and therefore Unity, round TimeSpan.FromSeconds to milliseconds. Measured and computed times go through this method instead.
internal static class PreciseTime
{
    public static TimeSpan FromSeconds(double seconds) => new(checked((long)(seconds * TimeSpan.TicksPerSecond)));
}
