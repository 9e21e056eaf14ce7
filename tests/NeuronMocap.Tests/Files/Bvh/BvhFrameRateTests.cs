using NeuronMocap.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhFrameRateTests
{
    [Theory]
    [InlineData("0.008", 120)]
    [InlineData("0.017", 60)]
    [InlineData("0.033", 30)]
    [InlineData("0.010", 100)]
    [InlineData("0.01", 100)]
    [InlineData("0.020", 50)]
    [InlineData("0.042", 24)]
    [InlineData("0.040", 25)]
    [InlineData("0.04", 25)]
    [InlineData("0.021", 48)]
    [InlineData("0.013", 75)]
    [InlineData("0.014", 72)]
    [InlineData("0.011", 90)]
    [InlineData("0.007", 144)]
    [InlineData("0.0067", 150)]
    [InlineData("0.005", 200)]
    [InlineData("0.004", 240)]
    [InlineData("0.0104", 96)]
    [InlineData("8e-3", 120)]
    [InlineData("0.8E-2", 120)]
    [InlineData("0.008333", 120)]
    [InlineData("0.0083333333333333332", 120)]
    [InlineData("0.00833333377", 120)]
    [InlineData("0.016667", 60)]
    [InlineData("0.01666666754", 60)]
    [InlineData("0.0333333", 30)]
    public void A_rounded_period_of_a_usual_rate_means_that_rate(string frameTime, double rate) =>
        Assert.Equal(rate, RateOf(frameTime));

    [Theory]
    [InlineData("0.0080", 125)]
    [InlineData("0.008000", 125)]
    [InlineData("0.0040", 250)]
    [InlineData("0.0170", 1 / 0.017)]
    [InlineData("0.0333667", 30 / 1.001)]
    [InlineData("0.1", 10)]
    [InlineData("1", 1)]
    [InlineData("0.001", 1000)]
    public void A_precise_unusual_time_is_kept(string frameTime, double rate)
    {
        BvhDocument document = Parse($"{Hierarchy}MOTION\nFrames: 0\nFrame Time: {frameTime}\n");

        Assert.Equal(rate, document.FrameRate, 1e-9);
        Assert.Equal(double.Parse(frameTime, System.Globalization.CultureInfo.InvariantCulture), document.DeclaredFrameTime);
    }

    [Theory]
    [InlineData("0")]
    [InlineData("-0.008")]
    [InlineData("nan")]
    [InlineData("inf")]
    [InlineData("1e400")]
    [InlineData("1e-300")]
    [InlineData("1e99999999999999999999")]
    [InlineData("0,008")]
    [InlineData("")]
    public void An_unusable_time_is_replaced_by_axis_neurons_rate_with_a_repair(string frameTime)
    {
        BvhDocument document = Parse($"{Hierarchy}MOTION\nFrames: 0\nFrame Time: {frameTime}\n");

        Assert.Equal(120, document.FrameRate);
        Assert.Equal(0, document.DeclaredFrameTime);
        Assert.Equal(
            [
                new BvhRepair(18, 13, $"'{frameTime}' is not a frame time; 120 Hz is assumed unless a valid one follows."),
            ],
            document.Repairs);
    }

    [Fact]
    public void A_missing_time_is_reported_once()
    {
        BvhDocument document = Parse($"{Hierarchy}MOTION\nFrames: 1\n{Row}MOTION\nFrames: 1\n{Row}");

        Assert.Equal(120, document.FrameRate);
        Assert.Single(document.Repairs, repair => repair.Description.Contains("frame time", StringComparison.Ordinal));
    }

    private static double RateOf(string frameTime) => Parse($"{Hierarchy}MOTION\nFrames: 0\nFrame Time: {frameTime}\n").FrameRate;
}
