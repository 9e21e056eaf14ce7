namespace NeuronMocap.Protocol;

/// <summary>Writes a binary32 as a decimal that <see cref="TextNumber"/> reads back as the same bits.</summary>
/// <remarks>
/// <para>
/// It uses only integers, so all runtimes and cultures give the same result. float.ToString rounds twice on Mono.
/// </para>
/// <para>
/// The text has the requested number of decimals if that text is read back as the value. It is then the exact expansion of the value, rounded to the
/// nearest, halves away from zero. Otherwise the text has the smallest sufficient number of decimals.
/// </para>
/// <para>
/// The text never has an exponent, because not every program that reads motion files supports one. Zero keeps its sign. Values that are not finite are
/// NaN, Infinity or -Infinity.
/// </para>
/// </remarks>
internal static class TextDigits
{
    /// <summary>Largest number of decimals that can be requested.</summary>
    public const int MaxDecimals = 16;

    /// <summary>Sufficient size for any value: a sign, 39 digits, a point and 16 decimals, or "-0." and 54 decimals.</summary>
    public const int MaxSize = 64;

    private const int HiddenBit = 1 << 23;

    // 256 bits: 24 bits times 10^54, or 24 bits shifted left by 104.
    private const int Limbs = 8;
    private const uint LimbDigits = 1_000_000_000;

    // A mantissa of 24 bits times the largest power is below 2^61, and stays below it when half of 2^60 is added.
    private const int LongestShortcut = 60;

    private static readonly ulong[] PowersOfTen =
    [
        1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000, 10_000_000_000, 100_000_000_000,
    ];

    /// <summary>Writes a value.</summary>
    /// <param name="destination">At least <see cref="MaxSize"/> bytes.</param>
    /// <param name="value">Any value.</param>
    /// <param name="decimals">Smallest number of digits after the point, 0 to 16; with 0 there is no point.</param>
    /// <returns>Number of bytes written.</returns>
    public static int Write(Span<byte> destination, float value, int decimals)
    {
        int bits = BitConverter.SingleToInt32Bits(value);
        int exponent = (bits >> 23) & 0xFF;
        uint fraction = (uint)bits & (HiddenBit - 1);
        if (exponent == 0xFF)
            return WriteNotFinite(destination, value);

        int sign = 0;
        if (bits < 0)
            destination[sign++] = (byte)'-';

        // value = mantissa * 2^power. At a power of two, the next lower value is half as far away as the next higher one.
        uint mantissa = exponent == 0 ? fraction : fraction | HiddenBit;
        int power = Math.Max(exponent, 1) - 150;
        bool isNarrowBelow = fraction == 0 && exponent > 1;
        if (mantissa == 0)
            return sign + Write(destination[sign..], 0, decimals);
        if (power >= 0)
            return sign + WriteInteger(destination[sign..], mantissa, power, decimals);

        for (; decimals < PowersOfTen.Length && -power <= LongestShortcut; decimals++)
        {
            if (TryRound(mantissa, -power, isNarrowBelow, decimals, out ulong digits))
                return sign + Write(destination[sign..], digits, decimals);
        }

        return sign + WriteLong(destination[sign..], mantissa, -power, isNarrowBelow, decimals);
    }

    private static int WriteNotFinite(Span<byte> destination, float value)
    {
        ReadOnlySpan<byte> text = float.IsNaN(value) ? "NaN"u8 : value > 0 ? "Infinity"u8 : "-Infinity"u8;
        text.CopyTo(destination);
        return text.Length;
    }

    // Returns true if digits / 10^decimals is closer to the value than to its neighbours. Halfway between two values, a reader chooses the even mantissa.
    private static bool TryRound(uint mantissa, int shift, bool isNarrowBelow, int decimals, out ulong digits)
    {
        ulong scaled = mantissa * PowersOfTen[decimals];
        digits = (scaled + (1UL << (shift - 1))) >> shift;
        ulong back = digits << shift;
        ulong spacing = PowersOfTen[decimals];
        if (back < scaled && isNarrowBelow)
            return (scaled - back) * 4 <= spacing;

        ulong twice = (back > scaled ? back - scaled : scaled - back) * 2;
        return twice < spacing || (twice == spacing && mantissa % 2 == 0);
    }

    // Writes from the last digit to the first, with the leading zeros that a number below one needs.
    private static int Write(Span<byte> destination, ulong number, int decimals)
    {
        int count = Math.Max(CountDigits(number), decimals + 1);
        int point = decimals == 0 ? -1 : count - decimals;
        int length = point < 0 ? count : count + 1;
        Span<byte> text = destination[..length];
        for (int i = text.Length - 1; i >= 0; i--)
        {
            if (i == point)
            {
                text[i] = (byte)'.';
                continue;
            }

            ulong rest = number / 10;
            text[i] = (byte)('0' + (number - (rest * 10)));
            number = rest;
        }

        return length;
    }

    private static int CountDigits(ulong number)
    {
        int count = 0;
        while (count < PowersOfTen.Length && number >= PowersOfTen[count])
            count++;

        for (ulong rest = number / PowersOfTen[^1]; rest >= 10; rest /= 10)
            count++;

        return count;
    }

    private static int WriteInteger(Span<byte> destination, uint mantissa, int power, int decimals)
    {
        var number = new WideInteger(stackalloc uint[Limbs]);
        number.Set(mantissa);
        number.ShiftLeft(power);
        Span<byte> reversed = stackalloc byte[MaxSize];
        reversed[..decimals].Fill((byte)'0');
        int count = decimals + Divide(number, reversed[decimals..]);
        return Write(destination, reversed, count, decimals);
    }

    // Does the same as Write and TryRound for values that do not fit into 64 bits; a take has few of them.
    private static int WriteLong(Span<byte> destination, uint mantissa, int shift, bool isNarrowBelow, int decimals)
    {
        var digits = new WideInteger(stackalloc uint[Limbs]);
        var distance = new WideInteger(stackalloc uint[Limbs]);
        var spacing = new WideInteger(stackalloc uint[Limbs]);
        decimals = Math.Max(decimals, LeadingZeros(shift));
        while (!TryRound(digits, distance, spacing, mantissa, shift, isNarrowBelow, decimals))
            decimals++;

        Span<byte> reversed = stackalloc byte[MaxSize];
        return Write(destination, reversed, Divide(digits, reversed), decimals);
    }

    // With fewer decimals, a value below 2^(24 - shift) would become zero: log10(2) = 0.30102...
    private static int LeadingZeros(int shift) => (shift - 24) * 301 / 1000;

    private static bool TryRound(
        WideInteger digits, WideInteger distance, WideInteger spacing, uint mantissa, int shift, bool isNarrowBelow, int decimals)
    {
        digits.Set(mantissa);
        spacing.Set(1);
        for (int i = 0; i < decimals; i++)
        {
            digits.Multiply(10);
            spacing.Multiply(10);
        }

        bool isUp = digits.HasBit(shift - 1);
        digits.CopyTo(distance);
        digits.ShiftRight(shift);
        if (isUp)
            digits.Increment();

        Differ(distance, digits, shift, isUp);
        distance.ShiftLeft(isNarrowBelow && !isUp ? 2 : 1);
        int compared = distance.CompareTo(spacing);
        return compared < 0 || (compared == 0 && mantissa % 2 == 0);
    }

    // Computes |scaled - digits * 2^shift| and stores it in scaled.
    private static void Differ(WideInteger scaled, WideInteger digits, int shift, bool isUp)
    {
        var back = new WideInteger(stackalloc uint[Limbs]);
        digits.CopyTo(back);
        back.ShiftLeft(shift);
        if (!isUp)
        {
            scaled.Subtract(back);
            return;
        }

        back.Subtract(scaled);
        back.CopyTo(scaled);
    }

    private static int Divide(WideInteger number, Span<byte> reversed)
    {
        int count = 0;
        while (!number.IsZero)
        {
            uint digits = number.Divide(LimbDigits);
            for (int i = 0; i < 9 && (digits > 0 || !number.IsZero); i++, digits /= 10)
                reversed[count++] = (byte)('0' + (digits % 10));
        }

        return count;
    }

    // The digits are in reverse order. Writes the leading zeros that a number below one needs.
    private static int Write(Span<byte> destination, Span<byte> reversed, int count, int decimals)
    {
        while (count <= decimals)
            reversed[count++] = (byte)'0';

        int length = 0;
        while (count > 0)
        {
            if (count == decimals)
                destination[length++] = (byte)'.';

            destination[length++] = reversed[--count];
        }

        return length;
    }
}
