namespace NeuronMocap.Timing;

// The frame rates that suits, cameras and animation programs use, in frames per second.
internal static class UsualRates
{
    // Clocks of suits are off by less than one per cent.
    private const double ClockTolerance = 0.01;

    // The first and the last frame of a measurement can be late by a few milliseconds.
    private const double ArrivalTolerance = 0.005; // s

    private static readonly short[] CommonRates = [24, 25, 30, 48, 50, 60, 72, 75, 80, 90, 96, 100, 120, 144, 150, 180, 200, 240, 300, 360];
    private static readonly short[] RareRates = [125, 250];
    private static readonly short[] TelevisionRates = [24, 30, 48, 60, 120, 240];

    public static ReadOnlySpan<short> Common => CommonRates;

    // These rates are near those of suits, but far less common. In the three decimals of Axis Neuron's files, 1/125 s is the same as 1/120 s.
    public static ReadOnlySpan<short> Rare => RareRates;

    // Each stands for 1000/1001 of the rate.
    public static ReadOnlySpan<short> Television => TelevisionRates;

    /// <summary>Finds the rate that a server is probably set to.</summary>
    /// <param name="measured">Measured frames per second.</param>
    /// <param name="seconds">Duration of the measurement, above 0. A short measurement is inexact.</param>
    /// <returns>The nearest usual rate; null if none is near.</returns>
    public static short? FindNearest(double measured, double seconds)
    {
        double tolerance = ClockTolerance + (ArrivalTolerance / seconds);
        return FindNearest(Common, measured, tolerance) ?? FindNearest(Rare, measured, tolerance);
    }

    private static short? FindNearest(ReadOnlySpan<short> rates, double measured, double tolerance)
    {
        short? nearest = null;
        foreach (short rate in rates)
        {
            double distance = Math.Abs((rate / measured) - 1);
            if (distance > tolerance)
                continue;

            tolerance = distance;
            nearest = rate;
        }

        return nearest;
    }
}
