using System.Globalization;

namespace NeuronMocap.Native.Tests.Processes;

public sealed class LimitTests
{
    private const int Attempts = 30;

    [Theory]
    [InlineData("addresses", 2_500_000)]
    [InlineData("descriptors", 64)]
    [InlineData("threads", 40)]
    public async Task The_library_works_within_narrow_limits(string what, int most) =>
        Assert.Equal(0, await GetFailuresAsync(what, most));

    [Theory]
    [InlineData("addresses", 20_000)]
    [InlineData("addresses", 200_000)]
    [InlineData("descriptors", 5)]
    [InlineData("threads", 0)]
    [InlineData("threads", 1)]
    [InlineData("threads", 4)]
    public async Task Connections_fail_cleanly_without_resources(string what, int most) =>
        Assert.Equal(Attempts, await GetFailuresAsync(what, most));

    [Theory]
    [InlineData("addresses", 350_000)]
    [InlineData("descriptors", 12)]
    [InlineData("threads", 9)]
    public async Task Some_connections_fail_with_few_resources(string what, int most) =>
        Assert.InRange(await GetFailuresAsync(what, most), 1, Attempts);

    private static async Task<int> GetFailuresAsync(string what, int most)
    {
        ProgramRun run = await ProgramRun.OfAsync("limits", what, most.ToString(CultureInfo.InvariantCulture));
        Assert.True(run.ExitCode == 0, $"{run}");
        return int.Parse(run.Output, CultureInfo.InvariantCulture);
    }
}
