namespace NeuronMocap.Protocol;

/// <summary>
/// Converts a decimal of any length to the nearest binary32, ties to even. It uses only integers and allocates nothing, so all runtimes give the same
/// result. This is the slow path of <see cref="TextNumber"/>.
/// </summary>
internal static class TextDecimal
{
    // The midpoint of two floats has at most 113 digits. Of the further digits it only matters whether one of them is not zero.
    private const int MaxDigits = 120;

    // Numbers from 10^39 on are infinite, and numbers below 10^-46 are zero: half of the smallest float is 7 * 10^-46.
    private const int Largest = 39;
    private const int Smallest = -46;

    // The largest number is 10^166, below 2^552, shifted left by the bits of a quotient.
    private const int Limbs = 20;

    // 24 bits of a float, and one or two bits for rounding.
    private const int QuotientBits = 26;
    private const int MantissaBits = 24;
    private const int SmallestPower = -150;

    private const uint Billion = 1_000_000_000;
    private const int DigitsOfABillion = 9;

    private const int DoubleBias = 1023;
    private const int DoubleFraction = 52;

    /// <summary>Converts (digits rest) * 10^exponent.</summary>
    /// <param name="digits">The first digits.</param>
    /// <param name="rest">The further digits, possibly with a point among them. They end before the first other character.</param>
    /// <param name="exponent">Power of ten of the last digit in <paramref name="digits"/>.</param>
    public static float ToSingle(ulong digits, ReadOnlySpan<byte> rest, int exponent)
    {
        var number = new WideInteger(stackalloc uint[Limbs]);
        number.Set((uint)(digits >> 32));
        number.ShiftLeft(32);
        number.Add((uint)digits);
        int count = CountDigits(digits);
        bool isMore = Append(number, rest, ref count, ref exponent);
        if (number.IsZero || count + exponent <= Smallest)
            return 0;

        return count + exponent > Largest ? float.PositiveInfinity : Divide(number, exponent, isMore);
    }

    private static int CountDigits(ulong digits)
    {
        int count = 0;
        for (; digits > 0; digits /= 10)
            count++;

        return count;
    }

    // Returns true if a digit that did not fit is not zero.
    private static bool Append(WideInteger number, ReadOnlySpan<byte> rest, ref int count, ref int exponent)
    {
        bool isMore = false;
        uint factor = 1;
        uint group = 0;
        foreach (byte letter in rest)
        {
            if (letter == '.')
                continue;

            uint digit = (uint)(letter - '0');
            if (digit > 9)
                break;

            if (count == MaxDigits)
            {
                isMore |= digit != 0;
                continue;
            }

            group = (group * 10) + digit;
            factor *= 10;
            count++;
            exponent--;
            if (factor < Billion)
                continue;

            number.Multiply(factor);
            number.Add(group);
            (factor, group) = (1, 0);
        }

        number.Multiply(factor);
        number.Add(group);
        return isMore;
    }

    private static float Divide(WideInteger number, int exponent, bool isMore)
    {
        var divisor = new WideInteger(stackalloc uint[Limbs]);
        divisor.Set(1);
        MultiplyByPowerOfTen(exponent < 0 ? divisor : number, Math.Abs(exponent));

        // number = quotient * 2^power * divisor, with as many bits in the quotient as rounding needs.
        int power = Math.Max(SmallestPower, number.BitLength - divisor.BitLength - MantissaBits - 1);
        if (power > 0)
            divisor.ShiftLeft(power);
        else
            number.ShiftLeft(-power);

        uint quotient = Divide(number, divisor);
        int excess = quotient >> (QuotientBits - 1) != 0 ? 2 : 1;
        return Round(quotient, excess, power, isMore || !number.IsZero);
    }

    private static void MultiplyByPowerOfTen(WideInteger number, int power)
    {
        for (; power >= DigitsOfABillion; power -= DigitsOfABillion)
            number.Multiply(Billion);
        for (; power > 0; power--)
            number.Multiply(10);
    }

    // Returns the quotient; the number becomes the remainder.
    private static uint Divide(WideInteger number, WideInteger divisor)
    {
        uint quotient = 0;
        divisor.ShiftLeft(QuotientBits - 1);
        for (int bit = QuotientBits; bit > 0; bit--)
        {
            quotient <<= 1;
            if (number.CompareTo(divisor) >= 0)
            {
                number.Subtract(divisor);
                quotient |= 1;
            }

            divisor.ShiftRight(1);
        }

        return quotient;
    }

    private static float Round(uint quotient, int excess, int power, bool isMore)
    {
        uint mantissa = quotient >> excess;
        uint discarded = quotient & ((1u << excess) - 1);
        uint half = 1u << (excess - 1);
        if (discarded > half || (discarded == half && (isMore || mantissa % 2 != 0)))
            mantissa++;

        // Exact in a double, and also in a float unless it is too large. The conversion then gives infinity.
        return (float)(mantissa * BitConverter.Int64BitsToDouble((long)(power + excess + DoubleBias) << DoubleFraction));
    }
}
