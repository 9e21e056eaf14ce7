using NeuronMocap.Bvh;

namespace NeuronMocap.Tests.Bvh;

public class BvhFrameTimeTests
{
    [Theory]
    [InlineData(120, 1, 120)]
    [InlineData(1, 1, 1)]
    [InlineData(59.94, 50, 2997)]
    [InlineData(60 / 1.001, 1001, 60000)]
    [InlineData(30000.0 / 1001, 1001, 30000)]
    [InlineData(0.5, 2, 1)]
    [InlineData(95.9, 10, 959)]
    [InlineData(1e6, 1, 1000000)]
    [InlineData(1 / 3600.0, 3600, 1)]
    [InlineData(1 / 0.017, 17, 1000)]
    public void A_rate_gives_the_simplest_fraction(double rate, long numerator, long denominator)
    {
        var time = BvhFrameTime.FromFrameRate(rate);

        Assert.Equal((numerator, denominator), (time.Numerator, time.Denominator));
        Assert.Equal(rate, time.FrameRate, rate * 1e-10);
        Assert.Equal(1 / rate, time.Seconds, 1e-10 / rate);
    }

    [Theory]
    [InlineData("0.008", 1, 120)]
    [InlineData("0.0080", 1, 125)]
    [InlineData("0.0170", 17, 1000)]
    [InlineData("0.033367", 1001, 30000)]
    [InlineData("0.0417083", 1001, 24000)]
    [InlineData("0.016683", 1001, 60000)]
    [InlineData("0.0083416667", 1001, 120000)]
    [InlineData("0.017000000", 17, 1000)]
    [InlineData("0.0104275287", 10, 959)]
    [InlineData("3600", 3600, 1)]
    [InlineData("1e-6", 1, 1000000)]
    [InlineData("0.00833333333333333333333333333333333333", 1, 120)]
    public void Text_gives_the_exact_time(string text, long numerator, long denominator)
    {
        Assert.True(BvhFrameTime.TryParse(text, out BvhFrameTime time));
        Assert.Equal(new BvhFrameTime(numerator, denominator), time);
    }

    [Theory]
    [InlineData(null)]
    [InlineData("")]
    [InlineData(" 0.008")]
    [InlineData("0")]
    [InlineData("-0.008")]
    [InlineData("nan")]
    [InlineData("3601")]
    [InlineData("1e-7")]
    public void Invalid_times_are_refused(string? text) => Assert.False(BvhFrameTime.TryParse(text, out _));

    [Theory]
    [InlineData(1, 120, "0.008333")]
    [InlineData(1, 125, "0.008000")]
    [InlineData(1, 60, "0.016667")]
    [InlineData(1001, 30000, "0.033367")]
    [InlineData(17, 1000, "0.017000")]
    [InlineData(2, 1, "2.000000")]
    public void A_written_time_reads_back_equal(long numerator, long denominator, string text)
    {
        var time = new BvhFrameTime(numerator, denominator);

        Assert.Equal(text, time.ToString());
        Assert.True(BvhFrameTime.TryParse(text, out BvhFrameTime read));
        Assert.Equal(time, read);
    }

    // Whatever the rate of a resampling, the written file states it exactly.
    [Fact]
    public void Rates_of_few_digits_survive_their_text()
    {
        for (int tenths = 10; tenths <= 4000; tenths++)
        {
            var time = BvhFrameTime.FromFrameRate(tenths / 10.0);
            Assert.True(BvhFrameTime.TryParse(time.ToString(), out BvhFrameTime read));
            Assert.True(time == read, $"{tenths / 10.0} Hz is written as {time} and read as {read.FrameRate} Hz.");
        }
    }

    [Fact]
    public void Any_number_is_read_exactly()
    {
        var random = new Random(5);
        for (int i = 0; i < 20_000; i++)
        {
            double seconds = Math.Pow(10, (random.NextDouble() * 9.5) - 6);
            string text = Math.Min(3599, seconds).ToString("F" + random.Next(6, 25), System.Globalization.CultureInfo.InvariantCulture);
            if (BvhFrameTime.TryParse(text, out BvhFrameTime time))
                Assert.Equal(double.Parse(text, System.Globalization.CultureInfo.InvariantCulture), time.Seconds, 1e-6);
            else
                Assert.InRange(double.Parse(text, System.Globalization.CultureInfo.InvariantCulture), 0, 1e-6);
        }
    }

    [Fact]
    public void Times_are_in_lowest_terms()
    {
        var time = new BvhFrameTime(250, 30_000);

        Assert.Equal(BvhFrameTime.Default, time);
        Assert.Equal((1, 120), (time.Numerator, time.Denominator));
        Assert.Equal(120, time.FrameRate);
        Assert.Equal((0, 1, 0.0), (default(BvhFrameTime).Numerator, default(BvhFrameTime).Denominator, default(BvhFrameTime).Seconds));
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new BvhFrameTime(0, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BvhFrameTime(1, 0));
        foreach (double rate in (double[])[0, -1, double.NaN, double.PositiveInfinity, 2e6, 1e-4])
            Assert.Throws<ArgumentOutOfRangeException>(() => BvhFrameTime.FromFrameRate(rate));
    }
}
