using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests.Processes;

public sealed class ThreadTests
{
    [Theory]
    [InlineData("small")]
    [InlineData("many")]
    [InlineData("random")]
    public Task Any_thread_may_call(string how) => ProgramRun.SucceedsAsync("threads", how);

    // Like callbacks that wait for the thread of a window.
    [Theory]
    [InlineData("read")]
    [InlineData("two")]
    [InlineData("exit")]
    public Task Closing_releases_callbacks_that_wait_for_the_closing_thread(string how) => ProgramRun.SucceedsAsync("late", how);

    [Fact]
    public Task Children_and_other_programs_may_be_started() => ProgramRun.SucceedsAsync("forks");

    [Fact]
    public async Task The_library_may_be_loaded_and_unloaded_repeatedly()
    {
        string library = NativeFiles.Library;
        string copy = Path.Combine(Directory.CreateTempSubdirectory("neuron").FullName, "copy.so");
        File.Copy(library, copy);
        try
        {
            await ProgramRun.SucceedsAsync("loads", library, copy);
        }
        finally
        {
            Directory.Delete(Path.GetDirectoryName(copy)!, recursive: true);
        }
    }
}
