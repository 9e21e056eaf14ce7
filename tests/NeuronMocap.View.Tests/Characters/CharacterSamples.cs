using System.Diagnostics;

namespace NeuronMocap.View.Tests.Characters;

/// <summary>Characters made of boxes.</summary>
internal static class CharacterSamples
{
    /// <summary>Writes them. Skips the test without Node.js and the packages of the page.</summary>
    public static async Task WriteAsync(string folder)
    {
        Assert.SkipUnless(Directory.Exists(Repository.PathOf("web", "node_modules")), "The packages of the folder web are not installed.");
        var start = new ProcessStartInfo("node", ["samples.mjs", folder]) { WorkingDirectory = Repository.PathOf("web"), UseShellExecute = false };
        Process? process = null;
        try
        {
            process = Process.Start(start)!;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            Assert.Skip("There is no node on the PATH.");
        }

        using (process)
        {
            await process.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
            Assert.Equal(0, process.ExitCode);
        }
    }
}
