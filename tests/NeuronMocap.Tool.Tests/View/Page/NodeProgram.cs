using System.Diagnostics;

namespace NeuronMocap.Tool.Tests.View.Page;

/// <summary>Runs Node in the folder web.</summary>
internal static class NodeProgram
{
    // Twenty times what the longest script takes while all cores are busy.
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(10);

    private static readonly string Folder = Repository.PathOf("web");

    public static bool Exists { get; } = InstalledPrograms.Have("node");

    /// <summary>Runs a script to its end, or skips the test if there is no Node or no package.</summary>
    /// <returns>The exit code, and what the script wrote.</returns>
    public static async Task<(int Code, string Output)> RunAsync(params string[] arguments)
    {
        Assert.SkipUnless(Exists, "There is no node on the PATH.");
        Assert.SkipUnless(Directory.Exists(Path.Combine(Folder, "node_modules")), "The packages of the folder web are not installed.");

        var start = new ProcessStartInfo("node", arguments)
        {
            WorkingDirectory = Folder,
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        using Process process = Process.Start(start)!;
        try
        {
            Task<string> output = process.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken);
            Task<string> error = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
            await process.WaitForExitAsync(TestContext.Current.CancellationToken).WaitAsync(Patience, TestContext.Current.CancellationToken);
            return (process.ExitCode, await output + await error);
        }
        finally
        {
            if (!process.HasExited)
                process.Kill(entireProcessTree: true);
        }
    }
}
