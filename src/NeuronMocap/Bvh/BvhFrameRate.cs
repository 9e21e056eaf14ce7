namespace NeuronMocap.Bvh;

/// <summary>
/// The rate behind a rounded frame time. Axis Neuron writes three decimals: 0.008 stands for 1/120 s, and a player that takes it for 1/125
/// runs four per cent fast. So the rate is the usual one whose period, rounded to as many digits, gives the text of the file; of
/// several, the one with the nearest period. Without any, the text is taken by its word.
/// <para>
/// 125 and 250 Hz are left out of the usual rates on purpose: to three decimals they cannot be told from 120 and 240, which motion capture
/// systems do run at. A file that means 125 says so with a fourth digit, 0.0080. The same holds for 100 against 96 the other way round:
/// 0.010 is exactly 100, and stays it.
/// </para>
/// </summary>
internal static class BvhFrameRate
{
    /// <summary>Hz, where a file does not say: that of Axis Neuron with up to 17 sensors.</summary>
    public const int Default = 120;

    private const double ShortestTime = 1e-6;
    private const double LongestTime = 3600;

    // Writers that keep the period as a float print all of its digits, of which the last ones are noise.
    private const double SinglePrecision = 1e-7;

    private static ReadOnlySpan<short> UsualRates =>
        [24, 25, 30, 48, 50, 60, 72, 75, 80, 90, 96, 100, 120, 144, 150, 180, 200, 240, 300, 360];

    public static bool IsUsable(double frameTime) => frameTime is >= ShortestTime and <= LongestTime;

    /// <summary>Finds the rate.</summary>
    /// <param name="frameTime">Seconds; usable.</param>
    /// <param name="lastDigit">The power of ten of its last digit in the file.</param>
    /// <returns>Hz.</returns>
    public static double Choose(double frameTime, int lastDigit)
    {
        double tolerance = Math.Max(0.5 * Math.Pow(10, lastDigit), frameTime * SinglePrecision);
        double best = 1 / frameTime;
        foreach (short rate in UsualRates)
        {
            double distance = Math.Abs((1.0 / rate) - frameTime);
            if (distance > tolerance)
                continue;

            tolerance = distance;
            best = rate;
        }

        return best;
    }
}
