using System.Diagnostics;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Terminal;

public sealed class StandardStreamsTests
{
    private const string FullDisk = "/dev/full";

    // Before, the process ended with SIGABRT.
    [Theory]
    [InlineData(2, "frobnicate")]
    [InlineData(2, "watch --frobnicate")]
    [InlineData(1, "info missing.bvh")]
    public async Task A_message_that_cannot_be_written_leaves_the_exit_code(int code, string args)
    {
        Assert.SkipUnless(File.Exists(FullDisk), "This system has no /dev/full.");
        string host = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        string command = $"'{host}' '{ToolProcess.PathOf("neuron-mocap")}' {args} 2> {FullDisk}";
        using Process shell = Process.Start(new ProcessStartInfo("/bin/sh", ["-c", command]) { UseShellExecute = false })!;
        await shell.WaitForExitAsync(TestContext.Current.CancellationToken);
        Assert.Equal(code, shell.ExitCode);
    }
}
