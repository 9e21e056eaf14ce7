using System.Globalization;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Timing;

namespace NeuronMocap.Bvh;

/// <summary>
/// Converts between a frame time and its rounded text.
/// </summary>
/// <remarks>
/// <para>
/// Axis Neuron writes three decimals: 0.008 stands for 1/120 s. A player that reads it as 1/125 s runs four per cent fast. The result is therefore
/// the period of the usual rate that gives the text of the file when rounded to as many digits. If several rates match, the nearest one is used. If
/// none matches, the television rates are tried, such as 1001/30000 s. If none of those matches either, the text is taken literally.
/// </para>
/// <para>
/// 125 and 250 Hz are deliberately not among these rates. With three decimals, their periods cannot be distinguished from those of 120 and 240
/// Hz, which are far more common. A file at 125 Hz has a fourth digit, 0.0080. The opposite holds for 100 and 96 Hz: 0.010 is exactly 100 Hz.
/// </para>
/// </remarks>
internal static class BvhFrameTimeText
{
    private const double ShortestTime = 1e-6;
    private const double LongestTime = 3600;

    // Some writers keep the period as a float and print all of its digits. The last digits are noise.
    private const double SinglePrecision = 1e-7;

    // A text with this many decimals stands for the simplest fraction within its rounding: no other likely rate is that near. A long holds at most
    // 15 decimals.
    private const int ManyDecimals = 9;
    private const int MaxDecimals = 15;
    private const int MinDecimalsWritten = 6;
    private const int LongestText = 128;

    /// <summary>Parses a word of a file.</summary>
    /// <param name="word">The word.</param>
    /// <param name="declared">The written value, in seconds.</param>
    /// <param name="time">The frame time that the value stands for.</param>
    /// <returns>True if the word is a number in the usable range, 1 µs to 1 h.</returns>
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

    /// <summary>Formats a time with as many decimals as are needed to read the same time again, at least six and at most fifteen.</summary>
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
        return Nearest(UsualRates.Common, 1000, declared, tolerance) ?? Nearest(UsualRates.Television, 1001, declared, tolerance);
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
            : SimplestFraction.Between(seconds - half, seconds + half);
        return new BvhFrameTime(numerator, divisor);
    }
}
