namespace NeuronMocap.Tests.Motion;

public sealed class ArrivalPatternTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void The_pattern_has_the_statistics_of_the_real_stream(int seed)
    {
        double[] arrivals = ArrivalPattern.Create(seed);
        double[] intervals = [.. arrivals.Skip(1).Zip(arrivals, (later, earlier) => Math.Round((later - earlier) * 1000))];
        double[] sorted = [.. intervals.Order()];
        double mean = intervals.Average();

        Assert.Equal(861, arrivals.Length);
        Assert.Equal(95.9, 860 / arrivals[^1], 0.05);
        Assert.Equal(10.43, mean, 0.005);
        Assert.Equal(1.47, Math.Sqrt(intervals.Average(interval => (interval - mean) * (interval - mean))), 0.005);
        Assert.Equal([7.0, 10, 13, 14, 22], new[] { 0.01, 0.5, 0.95, 0.99, 1 }.Select(part => sorted[(int)Math.Ceiling(part * 860) - 1]));
        Assert.Equal([22.0, 21], intervals.Where(interval => interval > 14));
        Assert.Equal([0.0, 0], intervals.Where((_, i) => i > 0 && intervals[i - 1] > 14));
    }
}
