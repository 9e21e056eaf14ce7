using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Protocol;

public class TextNumberTests
{
    [Theory]
    [InlineData("0")]
    [InlineData("-0")]
    [InlineData("-0.000000")]
    [InlineData("-0e-999999999999")]
    [InlineData("0e999999999999")]
    [InlineData("00012.500")]
    [InlineData("16777216")]
    [InlineData("16777217")]
    [InlineData("16777219")]
    [InlineData("16777217.0000000000000000000000000000000000000001")]
    [InlineData("9007199254740992")]
    [InlineData("9007199254740993")]
    [InlineData("12345678901234567890123456789")]
    [InlineData("0.00000000000000000000000000000000000000000000000000001")]
    [InlineData("3.4028234e38")]
    [InlineData("3.4028235e38")]
    [InlineData("3.4028235677973366e38")]
    [InlineData("3.4028236e38")]
    [InlineData("1e38")]
    [InlineData("1e39")]
    [InlineData("-1e99999999999")]
    [InlineData("1e-99999999999")]
    [InlineData("1e-45")]
    [InlineData("7.006492321624085e-46")]
    [InlineData("7.006492321624086e-46")]
    [InlineData("1.17549435e-38")]
    [InlineData("1.1754943508222875e-38")]
    [InlineData("5e-324")]
    [InlineData("1e22")]
    [InlineData("1e23")]
    [InlineData("9007199254740992e22")]
    [InlineData("1.00000017881393432617187499")]
    [InlineData("1.00000017881393432617187500")]
    [InlineData("1.00000017881393432617187501")]
    public void Edges_of_the_range_are_read_as_the_nearest_float(string text) => AssertNearest(text);

    [Theory]
    [InlineData("")]
    [InlineData("-")]
    [InlineData("+-1")]
    [InlineData(".")]
    [InlineData("-.")]
    [InlineData("1e")]
    [InlineData("1e+")]
    [InlineData("e5")]
    [InlineData(".e5")]
    [InlineData("1.2.3")]
    [InlineData("1,5")]
    [InlineData("1 ")]
    [InlineData("0x10")]
    [InlineData("1f")]
    [InlineData("--1")]
    [InlineData("1.#")]
    [InlineData("in")]
    public void Invalid_numbers_are_refused(string text)
    {
        Assert.False(TextNumber.TryParse(Encoding.UTF8.GetBytes(text), out float _));
        Assert.False(TextNumber.TryParse(Encoding.UTF8.GetBytes(text), out double _, out _));
    }

    // The output of a recorder, with various precisions.
    [Fact]
    public void Random_decimals_are_read_as_the_nearest_float()
    {
        var random = new Random(1);
        for (int i = 0; i < Trials.Of(100_000); i++)
        {
            double value = (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-3, 5));
            AssertNearest(value.ToString("F" + random.Next(0, 9), CultureInfo.InvariantCulture));
        }
    }

    [Fact]
    public void Random_digits_with_random_exponents_are_read_as_the_nearest_float()
    {
        var random = new Random(2);
        for (int i = 0; i < Trials.Of(50_000); i++)
        {
            string digits = string.Concat(Enumerable.Range(0, random.Next(1, 25)).Select(_ => random.Next(10)));
            AssertNearest(digits.Insert(random.Next(digits.Length + 1), ".") + "e" + random.Next(-70, 50).ToString(CultureInfo.InvariantCulture));
        }
    }

    // Halfway between two floats and just beside it, with as few digits as a double needs and with more than it holds.
    [Fact]
    public void Halfway_numbers_are_read_as_the_nearest_float()
    {
        var random = new Random(3);
        for (int i = 0; i < Trials.Of(5_000); i++)
        {
            int bits = random.Next(0x00800000, 0x7F000000);
            if (i % 2 == 0)
                bits = BitConverter.SingleToInt32Bits((float)(random.NextDouble() * 2000));

            double middle = ((double)BitConverter.Int32BitsToSingle(bits) + BitConverter.Int32BitsToSingle(bits + 1)) / 2;
            foreach (double near in (double[])[middle, Math.BitIncrement(middle), Math.BitDecrement(middle)])
            {
                AssertNearest(near.ToString("R", CultureInfo.InvariantCulture));
                AssertNearest(near.ToString("E40", CultureInfo.InvariantCulture));
                AssertNearest(near.ToString("E15", CultureInfo.InvariantCulture));
            }

            string beyond = middle.ToString("E60", CultureInfo.InvariantCulture);
            AssertNearest(beyond.Replace("E", "0000000000000001E", StringComparison.Ordinal));
        }
    }

    // As many digits as programs write, the powers of ten around the ends of the range, and words with thousands of digits.
    [Fact]
    public void Long_words_are_read_as_the_nearest_float()
    {
        var random = new Random(5);
        for (int i = 0; i < Trials.Of(50_000); i++)
        {
            int count = i % 100 == 0 ? random.Next(1, 3000) : random.Next(1, 150);
            string digits = string.Concat(Enumerable.Range(0, count).Select(_ => random.Next(10)));
            int point = random.Next(count + 1);
            int power = (i % 4) switch { 0 => random.Next(36, 41), 1 => random.Next(-48, -36), _ => random.Next(-60, 60) };
            AssertNearest((i % 2 == 0 ? "-" : "") + digits.Insert(point, ".") + "e" + (power - point).ToString(CultureInfo.InvariantCulture));
        }
    }

    // The exact middle of two floats has up to 113 digits. One further digit, wherever it is, rounds it to the upper float.
    [Fact]
    public void Exact_halfway_numbers_are_distinguished_from_their_neighbours()
    {
        var random = new Random(6);
        for (int i = 0; i < Trials.Of(10_000); i++)
        {
            int bits = (i % 4) switch
            {
                0 => random.Next(0x0080_0000), // subnormal
                1 => random.Next(0x7F00_0000, 0x7F80_0000), // up to the largest, next to infinity
                2 => random.Next(0x100) << 23, // just above and below a power of two
                _ => random.Next(0x7F80_0000),
            };
            bits = Math.Min(bits, 0x7F7F_FFFF);
            int exponent = Math.Max(1, bits >> 23);
            BigInteger twice = (2 * (bits >> 23 == 0 ? bits : (bits & 0x7F_FFFF) | 0x80_0000)) + 1;
            int power = exponent - 151;
            BigInteger middle = power >= 0 ? twice << power : twice * BigInteger.Pow(5, -power);
            string digits = middle.ToString(CultureInfo.InvariantCulture);
            string suffix = "e" + Math.Min(0, power).ToString(CultureInfo.InvariantCulture);
            string above = digits + "." + new string('0', random.Next(30)) + "1" + suffix;
            AssertNearest(digits + suffix);
            AssertNearest(digits + ".000" + suffix);
            AssertNearest(above);
            AssertNearest((middle - 1).ToString(CultureInfo.InvariantCulture) + ".999" + suffix);
            int upper = bits + 1;
            Assert.True(TextNumber.TryParse(Encoding.UTF8.GetBytes(above), out float value));
            Assert.Equal(upper, BitConverter.SingleToInt32Bits(value));
        }
    }

    [Theory]
    [InlineData("1e-2147483648")]
    [InlineData("1e2147483647")]
    [InlineData("-1e4294967296")]
    public void Hostile_words_are_read_as_the_nearest_float(string text)
    {
        AssertNearest(text);
        AssertNearest(new string('9', 60_000) + "e-59990");
        AssertNearest("0." + new string('0', 60_000) + "123456789012345678901234567890e60005");
        AssertNearest(new string('0', 60_000) + "16777217.000000000000000000001");
    }

    [Fact]
    public void The_slow_path_allocates_nothing()
    {
        byte[] word = Encoding.UTF8.GetBytes("16777217." + new string('0', 200) + "1e-3");
        Allocations.AssertNone(() => Assert.True(TextNumber.TryParse(word, out float _)));
    }

    [Theory]
    [InlineData("0.000000")]
    [InlineData("-0.000000")]
    [InlineData("179.123456")]
    [InlineData("-93.019646")]
    [InlineData("123456789.123456")]
    [InlineData("1.5")]
    [InlineData("5.")]
    [InlineData("0")]
    [InlineData("-90")]
    [InlineData("123456789012345")]
    [InlineData("1.23456789012345")]
    public void Numbers_of_motion_files_take_the_fast_path(string text)
    {
        foreach (char space in " \t\r\n\v\f")
        {
            Assert.True(TextNumber.TryParsePlain(Encoding.UTF8.GetBytes(text + space + new string('9', 32)), out float value, out int length));
            Assert.Equal(text.Length, length);
            Assert.Equal(BitConverter.SingleToInt32Bits(ExactDecimal.ToSingle(text)), BitConverter.SingleToInt32Bits(value));
        }
    }

    [Theory]
    [InlineData(" 1.5")]
    [InlineData("+1.5")]
    [InlineData("-")]
    [InlineData("- 5.5")]
    [InlineData(".5")]
    [InlineData("-.5")]
    [InlineData("16777217")]
    [InlineData("9876543210987654")]
    [InlineData("12:")]
    [InlineData("1.5e3")]
    [InlineData("1.5x")]
    [InlineData("1.234567x")]
    [InlineData("1.2345678901234567")]
    [InlineData("1234567890123456.5")]
    [InlineData("1234567890123456789012345678.5")]
    [InlineData("nan")]
    [InlineData("16777217.0")]
    [InlineData("1.234567:")]
    [InlineData("1.23456/ ")]
    [InlineData("1.2345/7 ")]
    public void Other_numbers_take_the_slow_path(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text + new string(' ', 32));
        Assert.False(TextNumber.TryParsePlain(bytes, out _, out _));
        Assert.False(TextNumber.TryParsePlain("1.5 "u8, out _, out _));
    }

    // Both ways of reading digits, all numbers of digits, and all possible following characters. The number always equals the framework's.
    [Fact]
    public void The_fast_path_matches_the_framework()
    {
        Runtimes.SkipOnMono("rounds twice, and reads a negative zero as zero.");
        var random = new Random(4);
        int plain = 0;
        for (int i = 0; i < 200_000; i++)
        {
            string digits = string.Concat(Enumerable.Range(0, random.Next(1, 18)).Select(_ => random.Next(10)));
            string number = (random.Next(2) == 0 ? "-" : "") + (random.Next(4) == 0 ? digits : digits.Insert(random.Next(digits.Length + 1), "."));
            byte[] text = Encoding.UTF8.GetBytes(number + " " + new string((char)random.Next(' ', '~'), 40));
            if (!TextNumber.TryParsePlain(text, out float value, out int length))
                continue;

            plain++;
            Assert.Equal(number.Length, length);
            if (BitConverter.SingleToInt32Bits(float.Parse(number, CultureInfo.InvariantCulture)) != BitConverter.SingleToInt32Bits(value))
                Assert.Fail($"{number} is read as {value:R}.");
        }

        Assert.InRange(plain, 100_000, 200_000);
    }

    [Fact]
    public void Doubles_are_read_with_their_last_decimal_place()
    {
        Assert.True(TextNumber.TryParse("0.0080"u8, out double value, out int lastDigit));
        Assert.Equal((0.008, -4), (value, lastDigit));
        Assert.True(TextNumber.TryParse("-12.5e3"u8, out value, out lastDigit));
        Assert.Equal((-12500, 2), (value, lastDigit));

        // More digits than the fast way reads.
        Assert.True(TextNumber.TryParse("-0.000000000000000000000000000000"u8, out value, out _));
        Assert.Equal(BitConverter.DoubleToInt64Bits(-0.0), BitConverter.DoubleToInt64Bits(value));
    }

    // All versions of the framework's parser read these correctly.
    [Fact]
    public void The_reference_parser_matches_the_framework()
    {
#if NET
        // .NET Framework rounds some texts twice.
        var random = new Random(7);
        for (int i = 0; i < 20_000; i++)
        {
            string text = ((random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-3, 5))).ToString("F" + random.Next(0, 9), CultureInfo.InvariantCulture);
            Assert.Equal(BitConverter.SingleToInt32Bits(float.Parse(text, CultureInfo.InvariantCulture)), BitConverter.SingleToInt32Bits(ExactDecimal.ToSingle(text)));
        }
#endif

        Assert.Equal(
            [0, 1, 0x7F7F_FFFF, 0x7F80_0000, 0x0080_0000, 0x4B80_0000],
            ((string[])["7e-46", "7.1e-46", "3.4028235e38", "3.4028236e38", "1.17549435e-38", "16777217"]).Select(static text => BitConverter.SingleToInt32Bits(ExactDecimal.ToSingle(text))));
    }

    private static void AssertNearest(string text)
    {
        float expected = ExactDecimal.ToSingle(text);
        Assert.True(TextNumber.TryParse(Encoding.UTF8.GetBytes(text), out float actual), text);
        if (BitConverter.SingleToInt32Bits(expected) != BitConverter.SingleToInt32Bits(actual))
            Assert.Fail($"{text} is read as {actual:R} instead of {expected:R}.");
    }
}
