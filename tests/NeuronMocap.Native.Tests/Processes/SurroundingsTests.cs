namespace NeuronMocap.Native.Tests.Processes;

public sealed class SurroundingsTests
{
    [Fact]
    public Task Locale_environment_folder_descriptors_children_and_threads_are_as_before() => ProgramRun.SucceedsAsync("surroundings");

    // Rounded upwards the first would be another number, and without denormal numbers the second would be zero.
    [Theory]
    [InlineData("0.1")]
    [InlineData("1e-40")]
    public Task The_floating_point_environment_is_the_callers_and_changes_no_number(string value) => ProgramRun.SucceedsAsync("floating", value);

    [Fact]
    public Task Arguments_that_make_no_sense_are_refused() => ProgramRun.SucceedsAsync("misuse");
}
