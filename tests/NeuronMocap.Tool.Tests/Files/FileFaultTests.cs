using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Files;

/// <summary>Files that cannot be opened are reported in words of the program, not of the runtime.</summary>
public sealed class FileFaultTests
{
    private static readonly string LongName = new('x', 300);

    [Theory]
    [InlineData("play", "/nowhere/take.nmrec", "does not exist")]
    [InlineData("play", "/proc", "is a folder")]
    [InlineData("play", "LONG", "longer than this file system allows")]
    [InlineData("--record", "/nowhere/take.nmrec", "'/nowhere', the folder for 'take.nmrec', does not exist")]
    [InlineData("--record", "/proc", "is a folder")]
    [InlineData("--record", "/proc/take.nmrec", "")]
    [InlineData("--record", "/sys/take.nmrec", "")]
    [InlineData("--record", "/dev/full", "only regular files are written.")]
    [InlineData("--record", "LONG", "longer than this file system allows")]
    [InlineData("--export", "/nowhere/take.bvh", "'/nowhere', the folder for 'take.bvh', does not exist")]
    [InlineData("--export", "/proc", "is a folder")]
    [InlineData("--export", "/proc/take.bvh", "")]
    [InlineData("--export", "/sys/take.bvh", "")]
    [InlineData("--export", "LONG.bvh", "longer than this file system allows")]
    public async Task A_file_that_cannot_be_opened_is_one_sentence(string option, string file, string said)
    {
        if (!OperatingSystem.IsLinux())
            Assert.Skip("The places are those of Linux.");

        ToolResult result = await ToolRunner.RunAsync(
            [.. option == "play" ? (string[])["play"] : ["watch", option], file.Replace("LONG", LongName, StringComparison.Ordinal), "--frames", "1", "--quiet"]);

        Assert.Equal(1, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.StartsWith(option == "play" ? "neuron-mocap: " : $"neuron-mocap: {option}: ", line, StringComparison.Ordinal);
        Assert.Contains(said, line, StringComparison.Ordinal);
        Assert.EndsWith(".", line, StringComparison.Ordinal);
        foreach (string raw in (string[])["Access to", "Could not find", "denied", "Parameter", "System.", " : "])
            Assert.DoesNotContain(raw, line, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("'/nowhere/take.bvh' does not exist.", "info", "/nowhere/take.bvh")]
    [InlineData("'/nowhere/take.bvh' does not exist.", "convert", "/nowhere/take.bvh", "out.nmrec")]
    [InlineData("longer than this file system allows.", "info", "LONG")]
    public async Task A_damaged_file_is_explained(string said, params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync([.. args.Select(static word => word.Replace("LONG", LongName, StringComparison.Ordinal))]);

        Assert.Equal(1, result.ExitCode);
        Assert.EndsWith(said, Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--record")]
    [InlineData("--export")]
    public async Task A_full_disk_is_reported_and_ends_with_1(string option)
    {
        if (!File.Exists("/dev/full"))
            Assert.Skip("This system has no device that is always full.");

        ToolResult result = await ToolRunner.RunAsync("watch", option, "/dev/full", "--overwrite", "--frames", "3", "--quiet");

        Assert.Equal(1, result.ExitCode);
        Assert.Contains(result.Error, static line => line.Contains("/dev/full", StringComparison.Ordinal));
        Assert.DoesNotContain(result.Error, static line => line.Contains("No space left", StringComparison.Ordinal));
    }
}
