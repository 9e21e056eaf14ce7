using System.Diagnostics;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Convert;

// A GLB file with so many keys that they wait in a temporary file.
public sealed class TemporaryFileTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_temporary_folder_that_does_not_exist_is_named()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows finds another folder.");
        AssertNamed(_folder["missing"], await ConvertAsync("exec \"$@\"", _folder["missing"]));
    }

    // A limit for the size of files stands in for a full disk.
    [Fact]
    public async Task A_full_temporary_folder_is_named_and_stays_empty()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Other systems have no such limit for a process.");
        string folder = Directory.CreateDirectory(_folder["full"]).FullName;
        AssertNamed(folder, await ConvertAsync("trap '' XFSZ; ulimit -f 20000; exec \"$@\"", folder));
        Assert.Empty(Directory.GetFiles(folder, "*.tmp"));
    }

    private void AssertNamed(string temporary, string error)
    {
        string line = Assert.Single(error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.StartsWith($"neuron-mocap: The folder for temporary files, '{temporary}", line, StringComparison.Ordinal);
        Assert.EndsWith("Set TMPDIR to another folder.", line, StringComparison.Ordinal);
        Assert.Equal(["take.bvh"], _folder.Names);
    }

    private async Task<string> ConvertAsync(string script, string temporary)
    {
        Takes.Actor(600).Save(_folder["take.bvh"]);
        string runtime = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        string[] tool = [runtime, ToolProcess.PathOf("neuron-mocap"), "convert", _folder["take.bvh"], _folder["take.glb"], "--resample", "10000"];
        var start = new ProcessStartInfo("sh", ["-c", script, "sh", .. tool]) { UseShellExecute = false, RedirectStandardError = true };
        start.Environment["TMPDIR"] = temporary;

        // The runtime's own files are larger with its usual protection of code.
        start.Environment["DOTNET_EnableWriteXorExecute"] = "0";
        using Process process = Process.Start(start)!;
        string error = await process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        await process.WaitForExitAsync(TestContext.Current.CancellationToken);
        Assert.Equal(1, process.ExitCode);
        return error;
    }
}
