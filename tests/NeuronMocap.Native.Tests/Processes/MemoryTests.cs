namespace NeuronMocap.Native.Tests.Processes;

// The program's view of memory: what the library does to it, and that memory checkers work with the library.
public sealed class MemoryTests
{
    // Valgrind runs one thread at a time, and each many times slower.
    private static readonly TimeSpan ValgrindLimit = 10 * Limits.Unexpected;

    [Theory]
    [InlineData("misuse")]
    [InlineData("floating")]
    [InlineData("late")]
    public Task The_address_sanitizer_finds_nothing(string name)
    {
        ProgramRun.PathOf(name);
        string program = $"{name}-checked";
        Assert.SkipUnless(File.Exists(Path.Combine(ProgramRun.Folder, $"process-{program}")), "The C compiler has no address sanitizer (libasan).");
        return ProgramRun.SucceedsAsync(program);
    }

    [Fact]
    public async Task Valgrind_finds_nothing()
    {
        const string valgrind = "/usr/bin/valgrind";
        Assert.SkipUnless(File.Exists(valgrind), "valgrind is not installed.");
        ProgramRun run = await ProgramRun.InAsync(
            ValgrindLimit, valgrind, "--quiet", "--error-exitcode=9", "--child-silent-after-fork=yes", ProgramRun.PathOf("misuse"));
        Assert.True(run.ExitCode == 0, run.Output);
    }
}
