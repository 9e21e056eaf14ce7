using System.Globalization;
using System.Numerics;

namespace NeuronMocap.Tests.Protocol;

/// <summary>
/// Converts a decimal to the nearest binary32, ties to even, by dividing integers of any size. It is independent of the runtime, because the parser
/// of .NET 8 is wrong for very small exponents and very long words.
/// </summary>
internal static class ExactDecimal
{
    private const int MantissaBits = 24;
    private const int SmallestPower = -149;

    // Powers of ten beyond which everything is infinite, or zero.
    private const int Largest = 60;
    private const int Smallest = -80;

    /// <summary>Reads a decimal with or without sign, point and exponent.</summary>
    public static float ToSingle(string text)
    {
        bool isNegative = text[0] == '-';
        string[] parts = text.TrimStart('-', '+').ToUpperInvariant().Split('E');
        int point = parts[0].IndexOf('.', StringComparison.Ordinal);
        int decimals = point < 0 ? 0 : parts[0].Length - point - 1;
        string digits = parts[0].Replace(".", "", StringComparison.Ordinal).TrimStart('0');
        BigInteger exponent = (parts.Length > 1 ? BigInteger.Parse(parts[1], NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture) : 0) - decimals;
        float magnitude = digits.Length == 0 || digits.Length + exponent < Smallest ? 0
            : digits.Length + exponent > Largest ? float.PositiveInfinity
            : Divide(BigInteger.Parse(digits, CultureInfo.InvariantCulture), (int)exponent);
        return isNegative ? -magnitude : magnitude;
    }

    private static float Divide(BigInteger numerator, int exponent)
    {
        BigInteger denominator = BigInteger.One;
        if (exponent < 0)
            denominator = BigInteger.Pow(10, -exponent);
        else
            numerator *= BigInteger.Pow(10, exponent);

        // If the estimate of the quotient is off by one bit, the mantissa shows it.
        int power = (int)(numerator.GetBitLength() - denominator.GetBitLength()) - MantissaBits;
        if ((Scale(numerator, -power) / Scale(denominator, power)).GetBitLength() > MantissaBits)
            power++;

        power = Math.Max(power, SmallestPower);
        BigInteger divisor = Scale(denominator, power);
        var mantissa = BigInteger.DivRem(Scale(numerator, -power), divisor, out BigInteger rest);
        int half = (2 * rest).CompareTo(divisor);
        if (half > 0 || (half == 0 && !mantissa.IsEven))
            mantissa++;

        // Both are exact in a double. Values too large for a float become infinite.
        return (float)((double)mantissa * Math.ScaleB(1, power));
    }

    private static BigInteger Scale(BigInteger number, int power) => power > 0 ? number << power : number;
}
