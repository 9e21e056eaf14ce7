namespace NeuronMocap.Polyfills;

// Members of TimeSpan, DateTimeOffset and Guid that netstandard2.0 lacks.
internal static class TimePolyfills
{
    extension(TimeSpan)
    {
        public static TimeSpan operator *(TimeSpan time, double factor) => new(checked((long)Math.Round(time.Ticks * factor)));

        public static TimeSpan operator /(TimeSpan time, double divisor) => new(checked((long)Math.Round(time.Ticks / divisor)));

        public static double operator /(TimeSpan time, TimeSpan other) => time.Ticks / (double)other.Ticks;
    }

    extension(DateTimeOffset)
    {
        public static DateTimeOffset UnixEpoch => new(1970, 1, 1, 0, 0, 0, TimeSpan.Zero);
    }
}
