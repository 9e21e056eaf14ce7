using System.Globalization;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Protocol;

public sealed class TextEncoderTests
{
    private readonly byte[] _buffer = new byte[100_000];

    [Fact]
    public void The_fixtures_lines_are_written_byte_for_byte()
    {
        StreamFixture fixture = StreamFixture.Load("text");
        int offset = 0;
        foreach (ExpectedPacket frame in fixture.Expected)
        {
            int length = TextEncoder.WriteMotion(_buffer, frame.Avatar, new AvatarName(frame.Name), frame.Values);
            Assert.Equal(Encoding.ASCII.GetString(fixture.Bytes.AsSpan(offset, length)), Encoding.ASCII.GetString(_buffer, 0, length));
            offset += length;
        }

        Assert.Equal(fixture.Bytes.Length, offset);
    }

    [Theory]
    [InlineData(0f, 2, "0.00")]
    [InlineData(-0f, 2, "-0.00")]
    [InlineData(-0.001f, 2, "-0.00")]
    [InlineData(0.125f, 2, "0.13")]
    [InlineData(-0.125f, 2, "-0.13")]
    [InlineData(0.995f, 2, "1.00")]
    [InlineData(9.994999f, 2, "9.99")]
    [InlineData(-179.99f, 2, "-179.99")]
    [InlineData(0.5f, 0, "1")]
    [InlineData(-1234567f, 0, "-1234567")]
    [InlineData(0.000001f, 6, "0.000001")]
    [InlineData(99.05f, 6, "99.050003")]
    [InlineData(5e8f, 6, "500000000.000000")]
    [InlineData(1e9f, 1, "999999999.0")]
    [InlineData(float.MaxValue, 0, "999999999")]
    [InlineData(float.NegativeInfinity, 2, "-999999999.00")]
    [InlineData(float.NaN, 2, "0.00")]
    [InlineData(float.Epsilon, 2, "0.00")]
    public void A_value_is_rounded_to_its_decimals_and_keeps_its_sign(float value, int decimals, string expected)
    {
        int length = TextEncoder.WriteCalculation(_buffer, [value], decimals);
        Assert.Equal(expected + "\n", Encoding.ASCII.GetString(_buffer, 0, length));
    }

    // The framework's conversion of the exact decimal value is the reference.
    [Fact]
    public void Every_value_is_the_nearest_number_of_its_decimals()
    {
        var random = new Random(5);
        for (int i = 0; i < 20_000; i++)
        {
            int decimals = i % 7;
            float value = (float)((random.NextDouble() - 0.5) * Math.Pow(10, random.Next(0, 9)));
            int length = TextEncoder.WriteCalculation(_buffer, [value], decimals);
            decimal written = decimal.Parse(Encoding.ASCII.GetString(_buffer, 0, length - 1), CultureInfo.InvariantCulture);
            decimal exact = new(Math.Round((double)value, 15 - Math.Max(0, (int)Math.Ceiling(Math.Log10(Math.Abs(value) + 1)))));
            decimal unit = 1;
            for (int digit = 0; digit < decimals; digit++)
                unit /= 10;

            Assert.True(Math.Abs(written - exact) <= (unit / 2) + 0.0000001m, $"{value:R} became {written}");
        }
    }

    [Theory]
    [InlineData("Ann", "Ann")]
    [InlineData("Ann Bell", "Ann_Bell")]
    [InlineData("a|b\tc\r\nd\u007F", "a_b_c__d_")]
    [InlineData("", "_")]
    [InlineData("7up", "7up")]
    [InlineData("演员 一", "演员_一")]
    [InlineData("01234567890123456789012345678901", "01234567890123456789012345678901")]
    public void Names_contain_no_separator(string name, string expected)
    {
        int length = TextEncoder.WriteMotion(_buffer, unchecked((int)4_000_000_000), new AvatarName(name), [1.5f, -2f], decimals: 1);
        Assert.Equal($"4000000000 {expected} 1.5 -2.0 ||\r\n", Encoding.UTF8.GetString(_buffer, 0, length));
    }

    [Fact]
    public void Calculation_columns_are_separated_by_one_space_and_end_with_lf()
    {
        float[] values = [.. Enumerable.Range(0, 946).Select(i => i - 473.25f)];
        int length = TextEncoder.WriteCalculation(_buffer, values);
        string line = Encoding.ASCII.GetString(_buffer, 0, length);
        Assert.Equal(string.Join(' ', values.Select(value => value.ToString("F2", CultureInfo.InvariantCulture))) + "\n", line);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    [InlineData(6)]
    public void The_maximum_length_is_exact(int decimals)
    {
        float[] values = [.. Enumerable.Repeat(-1e30f, 360)];
        var name = new AvatarName(new string('n', 32));
        int size = TextEncoder.GetMaxMotionSize(values.Length, decimals) + (decimals == 0 ? -values.Length : 0);
        Assert.Equal(size, TextEncoder.WriteMotion(_buffer, -1, name, values, decimals));
        Assert.ThrowsAny<ArgumentException>(() => TextEncoder.WriteMotion(_buffer.AsSpan(0, size - 1), -1, name, values, decimals));

        // There is no space before the first column.
        int calculation = TextEncoder.GetMaxCalculationSize(values.Length, decimals) + (decimals == 0 ? -values.Length : 0) - 1;
        Assert.Equal(calculation, TextEncoder.WriteCalculation(_buffer, values, decimals));
        Assert.ThrowsAny<ArgumentException>(() => TextEncoder.WriteCalculation(_buffer.AsSpan(0, calculation - 1), values, decimals));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(7)]
    public void Unsupported_decimals_are_refused(int decimals) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => TextEncoder.WriteCalculation(_buffer, [1], decimals));

    [Fact]
    public void Writing_allocates_nothing()
    {
        float[] values = [.. Enumerable.Range(0, 354).Select(i => i * 1.7f)];
        var name = new AvatarName("Ann Bell");
        Allocations.AssertNone(() => TextEncoder.WriteMotion(_buffer, 3, name, values));
    }
}
