using System.Diagnostics;
using NeuronMocap.View.Tests.Characters;

[assembly: AssemblyFixture(typeof(CharacterSamples))]

namespace NeuronMocap.View.Tests.Characters;

/// <summary>Characters made of boxes, written once for all tests.</summary>
public sealed class CharacterSamples : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("neuron-mocap-characters-");
    private bool _isWritten;

    /// <summary>Reads a sample. Skips the test without Node.js and the packages of the page.</summary>
    public async Task<byte[]> ReadAsync(string file)
    {
        if (!_isWritten)
            await WriteAsync(_folder.FullName);
        _isWritten = true;
        return await File.ReadAllBytesAsync(Path.Combine(_folder.FullName, file), TestContext.Current.CancellationToken);
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private static async Task WriteAsync(string folder)
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
