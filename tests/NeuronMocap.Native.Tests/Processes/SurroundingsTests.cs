namespace NeuronMocap.Native.Tests.Processes;

public sealed class SurroundingsTests
{
    [Fact]
    public Task The_process_environment_is_unchanged() => ProgramRun.SucceedsAsync("surroundings");

    // With rounding upwards, the first would be another number. Without denormal numbers, the second would be zero.
    [Theory]
    [InlineData("0.1")]
    [InlineData("1e-40")]
    public Task The_floating_point_environment_is_preserved_and_ignored(string value) => ProgramRun.SucceedsAsync("floating", value);

    [Fact]
    public Task Invalid_arguments_are_refused() => ProgramRun.SucceedsAsync("misuse");
}
