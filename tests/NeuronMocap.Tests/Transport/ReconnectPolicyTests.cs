namespace NeuronMocap.Tests.Transport;

public sealed class ReconnectPolicyTests
{
    [Theory]
    [InlineData(0, 250)]
    [InlineData(1, 250)]
    [InlineData(2, 500)]
    [InlineData(3, 1000)]
    [InlineData(5, 4000)]
    [InlineData(6, 5000)]
    [InlineData(1_000_000, 5000)]
    public void Delays_double_up_to_the_longest(int failures, double milliseconds) =>
        Assert.Equal(milliseconds, new ReconnectPolicy().GetDelay(failures, jitter: 0).TotalMilliseconds);

    [Fact]
    public void Jitter_shortens_a_delay_by_up_to_a_half() =>
        Assert.Equal(500, new ReconnectPolicy().GetDelay(failures: 3, jitter: 1).TotalMilliseconds);

    [Fact]
    public void Delays_out_of_range_are_refused_with_the_name_of_the_option()
    {
        var options = new NeuronReaderOptions { Reconnect = { InitialDelay = TimeSpan.Zero } };
        Assert.Contains("Reconnect.InitialDelay", Assert.Throws<ArgumentException>(() => new NeuronReader(options)).Message, StringComparison.Ordinal);
        options = new NeuronReaderOptions { Reconnect = { MaxDelay = TimeSpan.FromMilliseconds(1) } };
        Assert.Contains("Reconnect.MaxDelay", Assert.Throws<ArgumentException>(() => new NeuronReader(options)).Message, StringComparison.Ordinal);
    }
}
