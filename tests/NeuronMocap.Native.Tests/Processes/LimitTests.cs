using System.Globalization;

namespace NeuronMocap.Native.Tests.Processes;

public sealed class LimitTests
{
    private const int Attempts = 30;

    [Theory]
    [InlineData("addresses", 1_000_000)]
    [InlineData("descriptors", 64)]
    [InlineData("threads", 24)]
    public async Task It_works_within_limits_that_are_no_more_than_narrow(string what, int most) =>
        Assert.Equal(0, await GetFailuresAsync(what, most));

    [Theory]
    [InlineData("addresses", 20_000)]
    [InlineData("addresses", 200_000)]
    [InlineData("descriptors", 5)]
    [InlineData("threads", 0)]
    [InlineData("threads", 1)]
    [InlineData("threads", 4)]
    public async Task Where_there_is_not_enough_connections_fail_and_nothing_else_happens(string what, int most) =>
        Assert.Equal(Attempts, await GetFailuresAsync(what, most));

    [Theory]
    [InlineData("addresses", 350_000)]
    [InlineData("descriptors", 12)]
    [InlineData("threads", 9)]
    public async Task Where_there_is_little_some_fail(string what, int most) =>
        Assert.InRange(await GetFailuresAsync(what, most), 1, Attempts);

    private static async Task<int> GetFailuresAsync(string what, int most)
    {
        ProgramRun run = await ProgramRun.OfAsync("limits", what, most.ToString(CultureInfo.InvariantCulture));
        Assert.True(run.ExitCode == 0, $"{run}");
        return int.Parse(run.Output, CultureInfo.InvariantCulture);
    }
}
