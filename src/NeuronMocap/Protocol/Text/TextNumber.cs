using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace NeuronMocap.Protocol;

/// <summary>
/// Reads a decimal number as the nearest binary32, ties to even. On every runtime the result has the same bits as .NET's float.Parse with the invariant
/// culture.
/// </summary>
/// <remarks>
/// <para>
/// The short path handles nearly all numbers in motion files and text streams. It applies to a power of ten that a double holds exactly. With at most 53
/// bits of digits, one operation gives the double nearest to the decimal. With more digits, the result is off by a few last bits. The
/// conversion to a float rounds a second time. This fails only if the double lies halfway between two floats, or close to it.
/// <see cref="TextDecimal"/> handles this case and other powers.
/// </para>
/// <para>
/// The parsers of the runtimes do not suffice. float.Parse rounds twice on Mono. Utf8Parser rounds up halfway between two floats if zeros follow the
/// fraction (7.115569763501211648000000E+19, .NET 10).
/// </para>
/// </remarks>
internal static class TextNumber
{
    private const ulong ExactIntegers = 1UL << 53;
    private const ulong RoomForADigit = (ulong.MaxValue - 9) / 10;

    // A number of at most LongestPlain bytes always fits into 64 bits. PlainRoom is the number of bytes that must be readable.
    private const int LongestPlain = 16;
    private const int PlainRoom = 32;

    private const int LargestExponent = 99_999;
    private const long DiscardedBits = (1L << 29) - 1;
    private const long HalfOfThem = 1L << 28;

    // Largest error, in last bits of a double, of the operation on digits that do not fit into a double: slightly more than two, plus a reserve.
    private const long Uncertainty = 8;

    private static readonly double[] PowersOfTen =
    [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
    ];

    /// <summary>Reads a word that is a number from its first byte to its last. A number that is too large becomes infinite.</summary>
    public static bool TryParse(ReadOnlySpan<byte> word, out float value)
    {
        if (!TryScan(word, out Scanned number))
            return TryParseNotFinite(word, out value);
        if (number.HasExactPower && TryNarrow(number, out value))
            return true;

        ReadOnlySpan<byte> rest = number.CutAt > 0 ? word[number.CutAt..] : default;
        float magnitude = TextDecimal.ToSingle(number.Digits, rest, number.Exponent);
        value = number.IsNegative ? -magnitude : magnitude;
        return true;
    }

    /// <summary>
    /// Reads a number of the most common form from the start of a longer text. This form has digits, usually with a point among them,
    /// followed by white space.
    /// </summary>
    /// <remarks>
    /// Use <see cref="TryParse(ReadOnlySpan{byte}, out float)"/> for all other forms, and for a number close to the end of the text.
    /// </remarks>
    /// <param name="text">The number and the text after it.</param>
    /// <param name="value">The nearest binary32.</param>
    /// <param name="length">Size of the number in bytes, without the white space.</param>
    /// <returns>False if the text does not begin with such a number.</returns>
    public static bool TryParsePlain(ReadOnlySpan<byte> text, out float value, out int length)
    {
        value = 0;
        length = 0;
        if (text.Length < PlainRoom)
            return false;

        bool isNegative = text[0] == '-';
        int start = isNegative ? 1 : 0;
        int at = start;
        ulong digits = 0;
        uint digit;
        while ((digit = (uint)(text[at] - '0')) <= 9 && at < LongestPlain)
        {
            digits = (digits * 10) + digit;
            at++;
        }

        if (at == start)
            return false;

        int decimals = 0;
        if (text[at] == '.')
        {
            int point = at++;
            if (TryReadSixDigits(BinaryPrimitives.ReadUInt64LittleEndian(text[at..]), out uint six))
            {
                digits = (digits * 1_000_000) + six;
                at += 6;
            }
            else
            {
                while ((digit = (uint)(text[at] - '0')) <= 9 && at < LongestPlain)
                {
                    digits = (digits * 10) + digit;
                    at++;
                }
            }

            decimals = at - point - 1;
        }

        length = at;
        double magnitude = digits / PowersOfTen[decimals];
        value = isNegative ? -(float)magnitude : (float)magnitude;
        return at <= LongestPlain && digits <= ExactIntegers
            && text[at] is (byte)' ' or (>= (byte)'\t' and <= (byte)'\r')
            && (BitConverter.DoubleToInt64Bits(magnitude) & DiscardedBits) != HalfOfThem;
    }

    /// <summary>Reads a finite number as a double, and gets the power of ten of its last digit: -3 for 0.008.</summary>
    public static bool TryParse(ReadOnlySpan<byte> word, out double value, out int lastDigit)
    {
        value = 0;
        lastDigit = 0;
        if (!TryScan(word, out Scanned number))
            return false;

        lastDigit = number.Exponent;
        if (number.HasExactDigits && number.HasExactPower)
        {
            double magnitude = Approximate(number);
            value = number.IsNegative ? -magnitude : magnitude;
            return true;
        }

        if (!double.TryParse(Encoding.ASCII.GetString(word), NumberStyles.Float, CultureInfo.InvariantCulture, out value) || !double.IsFinite(value))
            return false;

        // .NET Framework and Mono read a negative zero as zero.
        value = number.IsNegative ? -Math.Abs(value) : value;
        return true;
    }

    // Reads exactly six digits, as Axis Neuron writes them, all at once. Each byte is a digit; neighbours are joined to pairs, and then to groups of four.
    private static bool TryReadSixDigits(ulong text, out uint value)
    {
        const ulong Zeros = 0x3030_3030_3030_3030;
        const ulong BeyondNine = 0x0606_0606_0606_0606;
        const ulong HighHalves = 0xF0F0_F0F0_F0F0_F0F0;
        const ulong FirstSix = 0x0000_FFFF_FFFF_FFFF;
        const ulong Seventh = 0x00FF_0000_0000_0000;

        ulong digits = text ^ Zeros;
        ulong others = (digits | (digits + BeyondNine)) & HighHalves;
        ulong eight = digits << 16;
        eight = ((eight * 10) + (eight >> 8)) & 0x00FF_00FF_00FF_00FF;
        eight = ((eight * 100) + (eight >> 16)) & 0x0000_FFFF_0000_FFFF;
        value = (uint)((eight * 10_000) + (eight >> 32));
        return (others & FirstSix) == 0 && (others & Seventh) != 0;
    }

    // Returns false if the double lies, or may lie, halfway between two floats: the decimal may lie on either side of it.
    private static bool TryNarrow(in Scanned number, out float value)
    {
        double magnitude = Approximate(number);
        value = number.IsNegative ? -(float)magnitude : (float)magnitude;
        long distance = Math.Abs((BitConverter.DoubleToInt64Bits(magnitude) & DiscardedBits) - HalfOfThem);
        return distance > (number.HasExactDigits ? 0 : Uncertainty);
    }

    // Returns the nearest double, if the digits are exact too.
    private static double Approximate(in Scanned number) => number.Exponent < 0
        ? number.Digits / PowersOfTen[-number.Exponent]
        : number.Digits * PowersOfTen[number.Exponent];

    private static bool TryScan(ReadOnlySpan<byte> word, out Scanned number)
    {
        number = default;
        int at = 0;
        if (word.Length > 0 && word[0] is (byte)'-' or (byte)'+')
            number.IsNegative = word[at++] == '-';

        int start = at;
        ScanDigits(word, ref at, ref number, exponentStep: 0);
        int digits = at - start;
        if (at < word.Length && word[at] == '.')
        {
            start = ++at;
            ScanDigits(word, ref at, ref number, exponentStep: -1);
            digits += at - start;
        }

        return digits > 0 && (at == word.Length || TryScanExponent(word[at..], ref number));
    }

    private static void ScanDigits(ReadOnlySpan<byte> word, ref int at, ref Scanned number, int exponentStep)
    {
        for (; at < word.Length && IsDigit(word[at]); at++)
        {
            if (number.Digits > RoomForADigit)
            {
                if (number.CutAt == 0)
                    number.CutAt = at;
                number.Exponent += exponentStep + 1;
                continue;
            }

            number.Digits = (number.Digits * 10) + (ulong)(word[at] - '0');
            number.Exponent += exponentStep;
        }
    }

    private static bool TryScanExponent(ReadOnlySpan<byte> word, ref Scanned number)
    {
        if (word[0] is not ((byte)'e' or (byte)'E'))
            return false;

        int at = word.Length > 1 && word[1] is (byte)'-' or (byte)'+' ? 2 : 1;
        bool isNegative = word.Length > 1 && word[1] == '-';
        if (at == word.Length)
            return false;

        int exponent = 0;
        for (; at < word.Length && IsDigit(word[at]); at++)
            exponent = Math.Min(LargestExponent, (exponent * 10) + (word[at] - '0'));

        number.Exponent += isNegative ? -exponent : exponent;
        return at == word.Length;
    }

    // Accepts the forms of float.Parse and those that C libraries print: nan, -nan(ind), inf, 1.#INF00, -1.#IND00, 1.#QNAN.
    private static bool TryParseNotFinite(ReadOnlySpan<byte> word, out float value)
    {
        bool isNegative = word.Length > 0 && word[0] == '-';
        if (isNegative || (word.Length > 0 && word[0] == '+'))
            word = word[1..];
        if (StartsWith(word, "1.#"u8))
            word = word[3..];

        bool isInfinite = StartsWith(word, "inf"u8);
        value = !isInfinite ? float.NaN : isNegative ? float.NegativeInfinity : float.PositiveInfinity;
        int length = isInfinite || StartsWith(word, "nan"u8) || StartsWith(word, "ind"u8) ? 3
            : StartsWith(word, "qnan"u8) || StartsWith(word, "snan"u8) ? 4
            : word.Length + 1;
        return length <= word.Length && EndsNotFinite(word[length..]);
    }

    // Accepts the end of the word, digits, a reason in brackets, or the end of "infinity". Nancy and Indy are names.
    private static bool EndsNotFinite(ReadOnlySpan<byte> rest)
    {
        if (rest.Length == 0 || rest[0] == '(')
            return true;

        int at = 0;
        while (at < rest.Length && IsDigit(rest[at]))
            at++;

        return at == rest.Length || (StartsWith(rest, "inity"u8) && rest.Length == 5);
    }

    // Ignores the case of the word; the keyword must be in lower case.
    private static bool StartsWith(ReadOnlySpan<byte> word, ReadOnlySpan<byte> keyword)
    {
        if (word.Length < keyword.Length)
            return false;

        for (int i = 0; i < keyword.Length; i++)
        {
            byte letter = word[i] is >= (byte)'A' and <= (byte)'Z' ? (byte)(word[i] | 0x20) : word[i];
            if (letter != keyword[i])
                return false;
        }

        return true;
    }

    private static bool IsDigit(byte letter) => letter is >= (byte)'0' and <= (byte)'9';

    // The value is Digits * 10^Exponent. CutAt is the place of the first digit that did not fit, or 0 if all fit; it is never the first character.
    private struct Scanned
    {
        public bool IsNegative;
        public ulong Digits;
        public int Exponent;
        public int CutAt;

        public readonly bool HasExactDigits => CutAt == 0 && Digits <= ExactIntegers;

        public readonly bool HasExactPower => Exponent > -PowersOfTen.Length && Exponent < PowersOfTen.Length;
    }
}
