using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Protocol;

public class TextDigitsTests
{
    [Theory]
    [InlineData(0f, 6, "0.000000")]
    [InlineData(-0f, 3, "-0.000")]
    [InlineData(93.019646f, 6, "93.019646")]
    [InlineData(-0.000001f, 6, "-0.000001")]
    [InlineData(0.1f, 6, "0.100000")]
    [InlineData(0.1f, 0, "0.1")]
    [InlineData(0.0625f, 3, "0.0625")]
    [InlineData(65536.0078125f, 6, "65536.007813")]
    [InlineData(16777216f, 2, "16777216.00")]
    [InlineData(7f, 0, "7")]
    [InlineData(1e20f, 1, "100000002004087734272.0")]
    [InlineData(float.MaxValue, 0, "340282346638528859811704183484516925440")]
    [InlineData(float.Epsilon, 3, "0.000000000000000000000000000000000000000000001")]
    [InlineData(float.NaN, 6, "NaN")]
    [InlineData(float.PositiveInfinity, 6, "Infinity")]
    [InlineData(float.NegativeInfinity, 6, "-Infinity")]
    public void Values_have_the_given_decimals_or_the_shortest(float value, int decimals, string expected) =>
        Assert.Equal(expected, Write(value, decimals));

    [Fact]
    public void The_culture_does_not_matter()
    {
        CultureInfo before = CultureInfo.CurrentCulture;
        var culture = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        culture.NumberFormat.NumberDecimalSeparator = ",";
        culture.NumberFormat.NegativeSign = "~";
        CultureInfo.CurrentCulture = culture;
        try
        {
            Assert.Equal("-1234.500", Write(-1234.5f, 3));
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Fact]
    public void Any_bits_are_read_back_from_the_fewest_exact_decimals()
    {
        var random = new Random(11);
        for (int round = 0; round < 20_000; round++)
            Check(BitConverter.Int32BitsToSingle(random.Next(int.MinValue, int.MaxValue)), random.Next(TextDigits.MaxDecimals + 1));
    }

    [Fact]
    public void Values_of_takes_are_read_back_from_the_fewest_exact_decimals()
    {
        var random = new Random(12);
        for (int round = 0; round < 10_000; round++)
            Check((random.NextSingle() - 0.5f) * 400, random.Next(9));
    }

    // At every power of two, the distance to the next value doubles. The smallest values have fewer bits.
    [Fact]
    public void The_neighbours_of_all_powers_of_two_are_read_back_from_the_fewest_exact_decimals()
    {
        for (int bits = 0; bits < 0x7F80_0000; bits += 1 << 23)
        {
            foreach (int step in (int[])[-2, -1, 0, 1, 2, 3])
                Check(BitConverter.Int32BitsToSingle(Math.Max(0, bits + step)), (bits >> 23) % 9);
        }
    }

    [Fact]
    public void The_smallest_values_are_read_back()
    {
        for (int bits = 0; bits < 5000; bits++)
            Check(BitConverter.Int32BitsToSingle(bits), 6);
    }

    [Fact]
    public void Writing_allocates_nothing()
    {
        byte[] text = new byte[TextDigits.MaxSize];
        float[] values = [93.019646f, 1e-40f, 1e30f, 0.333333f, float.NaN];
        Allocations.AssertNone(() =>
        {
            foreach (float value in values)
                TextDigits.Write(text, value, 6);
        });
    }

    private static void Check(float value, int decimals)
    {
        string text = Write(value, decimals);
        AssertReadBack(value, text);
        if (!float.IsFinite(value))
            return;

        int point = text.IndexOf('.', StringComparison.Ordinal);
        int written = point < 0 ? 0 : text.Length - point - 1;
        Assert.True(written >= decimals, text);
        Assert.Equal(Round(value, written), text);
        if (written > decimals)
            Assert.False(IsReadBack(value, Round(value, written - 1)), $"{text} has more decimals than it needs.");
    }

    // TextNumber reads our own files, and float.Parse of .NET is exact too.
    private static void AssertReadBack(float value, string text)
    {
        Assert.True(IsReadBack(value, text), $"{value:R} was written as {text}.");
        Assert.True(TextNumber.TryParse(Encoding.ASCII.GetBytes(text), out float read));
        Assert.True(AreSame(value, read), $"{value:R} was read back from {text} as {read:R}.");
    }

    private static bool IsReadBack(float value, string text) => AreSame(value, float.Parse(text, CultureInfo.InvariantCulture));

    // Text does not distinguish the many patterns of NaN.
    private static bool AreSame(float value, float other) =>
        BitConverter.SingleToInt32Bits(value) == BitConverter.SingleToInt32Bits(other) || (float.IsNaN(value) && float.IsNaN(other));

    // The value as a fraction of integers, rounded by long division.
    private static string Round(float value, int decimals)
    {
        int bits = BitConverter.SingleToInt32Bits(value);
        int exponent = (bits >> 23) & 0xFF;
        BigInteger mantissa = (bits & 0x7F_FFFF) + (exponent == 0 ? 0 : 0x80_0000);
        BigInteger numerator = mantissa * BigInteger.Pow(2, Math.Max(exponent, 1)) * BigInteger.Pow(10, decimals);
        BigInteger digits = ((2 * numerator) + BigInteger.Pow(2, 150)) / BigInteger.Pow(2, 151);
        string text = digits.ToString(CultureInfo.InvariantCulture).PadLeft(decimals + 1, '0');
        return (bits < 0 ? "-" : "") + (decimals == 0 ? text : text.Insert(text.Length - decimals, "."));
    }

    private static string Write(float value, int decimals)
    {
        byte[] text = new byte[TextDigits.MaxSize];
        return Encoding.ASCII.GetString(text, 0, TextDigits.Write(text, value, decimals));
    }
}
