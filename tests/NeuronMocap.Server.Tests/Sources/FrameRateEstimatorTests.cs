namespace NeuronMocap.Server.Tests.Sources;

public sealed class FrameRateEstimatorTests
{
    [Theory]
    [InlineData(60)]
    [InlineData(90)]
    [InlineData(125)]
    [InlineData(59.94)]
    [InlineData(97.3)]
    [InlineData(59.94005994005994)]
    [InlineData(1000)]
    [InlineData(0.5)]
    public void Even_times_give_the_exact_rate(double rate)
    {
        foreach (int count in (int[])[10, 1000])
        {
            var estimate = new FrameRateEstimator();
            for (int frame = 0; frame < count; frame++)
                estimate.Add(frame, TimeOf(frame, rate) + TimeSpan.FromSeconds(3));

            Assert.True(estimate.IsUniform);
            Assert.Equal(rate, estimate.FrameRate!.Value, rate * 1e-12);
        }
    }

    [Theory]
    [InlineData(59.941257567583767)] // 0.016683 s
    [InlineData(100.123456789)]
    public void Unusual_rates_reproduce_the_times(double rate)
    {
        var estimate = new FrameRateEstimator();
        for (int frame = 0; frame < 5000; frame++)
            estimate.Add(frame, TimeOf(frame, rate));

        for (int frame = 0; frame < 5000; frame++)
            Assert.InRange((TimeOf(frame, rate) - TimeOf(frame, estimate.FrameRate!.Value)).Ticks, -1, 1);
    }

    [Fact]
    public void Missing_frames_do_not_change_the_rate()
    {
        var estimate = new FrameRateEstimator();
        foreach (int frame in (int[])[0, 1, 2, 7, 8, 30])
            estimate.Add(frame, TimeOf(frame, 97.3));

        Assert.Equal(97.3, estimate.FrameRate!.Value, 1e-9);
    }

    [Fact]
    public void Jittered_times_give_the_usual_rate()
    {
        var random = new Random(1);
        var estimate = new FrameRateEstimator();
        for (int frame = 0; frame < 1000; frame++)
            estimate.Add(frame, TimeOf(frame, 95.9) + TimeSpan.FromMilliseconds(random.NextDouble()));

        Assert.False(estimate.IsUniform);
        Assert.Equal(96, estimate.FrameRate);
        Assert.InRange(estimate.MeasuredFrameRate!.Value, 95.8, 96);
    }

    [Fact]
    public void Fewer_than_two_frames_give_no_rate()
    {
        var estimate = new FrameRateEstimator();
        Assert.Null(estimate.FrameRate);
        estimate.Restart(5, TimeSpan.FromSeconds(1));
        Assert.Null(estimate.FrameRate);
        Assert.Null(estimate.MeasuredFrameRate);
        Assert.False(estimate.IsUniform);
    }

    [Fact]
    public void A_restart_does_not_change_the_rate()
    {
        var estimate = new FrameRateEstimator();
        for (int frame = 0; frame < 10; frame++)
            estimate.Add(frame, TimeOf(frame, 60));

        estimate.Restart(100, TimeSpan.FromHours(1));
        for (int frame = 1; frame < 10; frame++)
            estimate.Add(100 + frame, TimeSpan.FromHours(1) + TimeOf(frame, 60));

        Assert.False(estimate.IsUniform);
        Assert.Equal(60, estimate.FrameRate);
    }

    [Fact]
    public void Constant_or_decreasing_times_give_no_rate()
    {
        var estimate = new FrameRateEstimator();
        for (int frame = 0; frame < 10; frame++)
            estimate.Add(frame, TimeSpan.FromSeconds(-frame));

        Assert.False(estimate.IsUniform);
        Assert.Null(estimate.FrameRate);
    }

    private static TimeSpan TimeOf(long frame, double rate) => TimeSpan.FromTicks((long)Math.Round(frame * (TimeSpan.TicksPerSecond / rate)));
}
