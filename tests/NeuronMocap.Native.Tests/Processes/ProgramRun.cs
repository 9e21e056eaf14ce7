using System.Diagnostics;

namespace NeuronMocap.Native.Tests.Processes;

/// <summary>A finished program of tests/native/process: its exit code (128 or more for a signal) and all its output.</summary>
internal sealed record ProgramRun(int ExitCode, string Output)
{
    public static string Folder => Path.Combine(AppContext.BaseDirectory, "native");

    public static Task<ProgramRun> OfAsync(string name, params string[] arguments) => InAsync(PathOf(name), arguments);

    /// <summary>Runs it, and asserts that it succeeds without output.</summary>
    public static async Task SucceedsAsync(string name, params string[] arguments) =>
        Assert.Equal(new ProgramRun(0, string.Empty), await OfAsync(name, arguments));

    public static string PathOf(string name)
    {
        string path = Path.Combine(Folder, "process-" + name);
        Assert.SkipUnless(File.Exists(path), "The C programs are not built: a C compiler and CMake are needed, on Linux.");
        return path;
    }

    public static Task<ProgramRun> InAsync(string program, params string[] arguments) => InAsync(Limits.Unexpected, program, arguments);

    public static async Task<ProgramRun> InAsync(TimeSpan limit, string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            UseShellExecute = false,
        };
        using Process process = Process.Start(start)!;
        try
        {
            process.StandardInput.Close();
            string[] texts = await Task.WhenAll(process.StandardOutput.ReadToEndAsync(), process.StandardError.ReadToEndAsync())
                .WaitAsync(limit, TestContext.Current.CancellationToken);
            await process.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
            return new ProgramRun(process.ExitCode, string.Concat(texts));
        }
        finally
        {
            if (!process.HasExited)
                process.Kill(entireProcessTree: true);
        }
    }
}
