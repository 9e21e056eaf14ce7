namespace NeuronMocap.Native.Tests.Processes;

public sealed class ExitTests
{
    private const int Runs = 12;
    private const int AtOnce = 4;
    private const int Aborted = 134;

    [Theory]
    [InlineData("return")]
    [InlineData("exit")]
    [InlineData("quick_exit")]
    [InlineData("_exit")]
    [InlineData("pthread_exit")]
    [InlineData("exit-in-thread")]
    [InlineData("exit-in-callback")]
    [InlineData("at-once")]
    [InlineData("abort", Aborted)]
    public async Task A_receiving_program_may_exit_in_any_way(string how, int expected = 0)
    {
        for (int i = 0; i < Runs; i += AtOnce)
        {
            ProgramRun[] runs = await Task.WhenAll(Enumerable.Range(0, AtOnce).Select(_ => ProgramRun.OfAsync("exits", how)));
            Assert.All(runs, run => Assert.Equal(new ProgramRun(expected, string.Empty), run));
        }
    }

    [Theory]
    [InlineData("thrown in a frame's callback")]
    [InlineData("thrown in a status callback", "status")]
    public async Task A_Cpp_exception_in_a_callback_terminates_at_its_throw(string text, params string[] arguments)
    {
        ProgramRun run = await ProgramRun.OfAsync("throws", arguments);
        Assert.Equal(Aborted, run.ExitCode);
        Assert.Contains(text, run.Output, StringComparison.Ordinal);
    }
}
