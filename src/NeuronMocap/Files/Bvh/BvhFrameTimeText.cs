using System.Globalization;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Bvh;

/// <summary>
/// The time behind a rounded text. Axis Neuron writes three decimals: 0.008 stands for 1/120 s, and a player that takes it for 1/125
/// runs four per cent fast. So the time is the period of the usual rate that, rounded to as many digits, gives the text of the file; of
/// several, the nearest. Without any, those of television, 1001/30000 s and the like; then the text is taken by its word.
/// <para>
/// 125 and 250 Hz are left out of the usual rates on purpose: to three decimals they cannot be told from 120 and 240, which are the more
/// common by far. A file that means 125 says so with a fourth digit, 0.0080. The same holds for 100 against 96 the other way round:
/// 0.010 is exactly 100, and stays it.
/// </para>
/// </summary>
internal static class BvhFrameTimeText
{
    private const double ShortestTime = 1e-6;
    private const double LongestTime = 3600;

    // Writers that keep the period as a float print all of its digits, of which the last ones are noise.
    private const double SinglePrecision = 1e-7;

    // With so many decimals the simplest fraction that they allow is meant: no other one of a likely rate is near. It has at most 15 in a long.
    private const int ManyDecimals = 9;
    private const int MaxDecimals = 15;
    private const int MinDecimalsWritten = 6;
    private const int LongestText = 128;

    // Also what a measured rate is taken for that is near to one of them.
    internal static ReadOnlySpan<short> UsualRates =>
        [24, 25, 30, 48, 50, 60, 72, 75, 80, 90, 96, 100, 120, 144, 150, 180, 200, 240, 300, 360];

    internal static ReadOnlySpan<short> TelevisionRates => [24, 30, 48, 60, 120, 240];

    /// <summary>Reads a word of a file.</summary>
    /// <param name="word">The word.</param>
    /// <param name="declared">Its value, in seconds.</param>
    /// <param name="time">What it means.</param>
    /// <returns>False when it is not a number, or not one of the times that are usable, 1 µs to 1 h.</returns>
    public static bool TryParse(ReadOnlySpan<byte> word, out double declared, out BvhFrameTime time)
    {
        time = default;
        if (word.Length > LongestText
            || !TextNumber.TryParse(word, out declared, out int lastDigit)
            || declared is not (>= ShortestTime and <= LongestTime))
        {
            declared = 0;
            return false;
        }

        time = Choose(declared, lastDigit) ?? UseAsWritten(word, Math.Max(0, -lastDigit));
        return true;
    }

    /// <summary>Writes a time with as many decimals as it takes to be read again as the same, at least six and at most fifteen.</summary>
    public static string Create(BvhFrameTime time)
    {
        decimal seconds = time.Numerator / (decimal)time.Denominator;
        for (int decimals = MinDecimalsWritten; ; decimals++)
        {
            string text = seconds.ToString("F" + decimals, CultureInfo.InvariantCulture);
            bool isSame = TryParse(Encoding.ASCII.GetBytes(text), out _, out BvhFrameTime read) && read == time;
            if (isSame || decimals == MaxDecimals)
                return text;
        }
    }

    private static BvhFrameTime? Choose(double declared, int lastDigit)
    {
        double tolerance = Math.Max(0.5 * Math.Pow(10, lastDigit), declared * SinglePrecision);
        return Nearest(UsualRates, 1000, declared, tolerance) ?? Nearest(TelevisionRates, 1001, declared, tolerance);
    }

    private static BvhFrameTime? Nearest(ReadOnlySpan<short> rates, long milliseconds, double declared, double tolerance)
    {
        BvhFrameTime? nearest = null;
        foreach (short rate in rates)
        {
            double distance = Math.Abs(((double)milliseconds / (rate * 1000)) - declared);
            if (distance > tolerance)
                continue;

            tolerance = distance;
            nearest = new BvhFrameTime(milliseconds, rate * 1000);
        }

        return nearest;
    }

    private static BvhFrameTime UseAsWritten(ReadOnlySpan<byte> word, int decimals)
    {
        decimal seconds = decimal.Parse(Encoding.ASCII.GetString(word), NumberStyles.Float, CultureInfo.InvariantCulture);
        long denominator = 1;
        for (int i = 0; i < Math.Min(decimals, MaxDecimals); i++)
            denominator *= 10;

        decimal half = 0.5m / denominator;
        (long numerator, long divisor) = decimals < ManyDecimals
            ? ((long)(seconds * denominator), denominator)
            : BvhFrameTime.SimplestFraction(seconds - half, seconds + half);
        return new BvhFrameTime(numerator, divisor);
    }
}
