namespace NeuronMocap.Native.Tests.Processes;

public sealed class SignalTests
{
    private const int Quit = 3;
    private const int Fpe = 8;
    private const int Segv = 11;
    private const int Pipe = 13;
    private const int Term = 15;
    private const int FirstRealTime = 34;

    [Fact]
    public Task Signal_dispositions_handlers_and_masks_are_unchanged() => ProgramRun.SucceedsAsync("signals");

    [Theory]
    [InlineData(Quit)]
    [InlineData(Fpe)]
    [InlineData(Segv)]
    [InlineData(Pipe)]
    [InlineData(Term)]
    [InlineData(FirstRealTime)]
    public async Task A_signal_without_a_handler_ends_the_program(int signal) =>
        Assert.Equal(new ProgramRun(128 + signal, string.Empty), await ProgramRun.OfAsync("dies", $"{signal}"));

    [Theory]
    [InlineData(Fpe)]
    [InlineData(Segv)]
    public async Task A_fault_of_the_program_ends_it_by_its_signal(int signal) =>
        Assert.Equal(new ProgramRun(128 + signal, string.Empty), await ProgramRun.OfAsync("dies", $"{signal}", "fault"));
}
