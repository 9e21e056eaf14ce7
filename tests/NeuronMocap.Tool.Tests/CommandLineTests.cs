using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests;

public sealed class CommandLineTests
{
    [Theory]
    [InlineData("--frames", "--frames", "0")]
    [InlineData("--frames", "--frames", "-1")]
    [InlineData("--frames", "--frames", "1.5")]
    [InlineData("--frames", "--frames")]
    [InlineData("--duration", "--duration", "0")]
    [InlineData("--duration", "--duration", "NaN")]
    [InlineData("--duration", "--duration", "1,5")]
    [InlineData("--duration", "--duration", "1000001")]
    [InlineData("--udp", "--udp", "0")]
    [InlineData("--udp", "--udp", "65536")]
    [InlineData("--order", "--order", "XXY")]
    [InlineData("--order", "--order", "1")]
    [InlineData("--connect", "--connect", "studio:port")]
    [InlineData("--udp", "--connect", "studio", "--udp", "7001")]
    [InlineData("--demo", "--connect", "studio", "--demo")]
    [InlineData("--quiet", "--json", "--quiet")]
    [InlineData("--allow-sender", "--udp", "7001", "--allow-sender", "studio")]
    [InlineData("--allow-sender", "--udp", "7001", "--allow-sender")]
    [InlineData("--udp", "--connect", "studio", "--allow-sender", "127.0.0.1")]
    [InlineData("--udp", "--allow-sender", "127.0.0.1")]
    [InlineData("--command-port", "--connect", "studio", "--command-port", "0")]
    [InlineData("--connect", "--command-port", "8013")]
    [InlineData("--connect", "--udp", "7001", "--command-port", "8013")]
    [InlineData("--commands", "--commands", "studio:port")]
    [InlineData("--commands", "--avatar", "1")]
    [InlineData("--commands", "--zero-out", "all")]
    [InlineData("--commands", "--bvh-header")]
    [InlineData("--avatar", "--commands", "--avatar", "-1")]
    [InlineData("--zero-out", "--commands", "--zero-out", "some")]
    [InlineData("--zero-out", "--commands", "--zero-out", "1", "--avatar", "1")]
    [InlineData("--json", "--commands", "--bvh-header", "--json")]
    [InlineData("--connect", "--commands", "--connect", "studio")]
    [InlineData("--diagnose", "--commands", "--diagnose")]
    [InlineData("--quiet", "--commands", "--quiet")]
    [InlineData("--record", "--record")]
    [InlineData("--record", "--record", " ")]
    [InlineData("--record", "--record-compress")]
    [InlineData("--record-size", "--record", "take", "--record-size", "1")]
    [InlineData("--record-time", "--record", "take", "--record-time", "0")]
    [InlineData("--record-files", "--record", "take", "--record-files", "3")]
    [InlineData("take.bvh", "--record", "take.bvh")]
    [InlineData(".nmrec", "--record", "take.bvh")]
    [InlineData("take.fbx", "--export", "take.fbx")]
    [InlineData(".bvh", "--export", "take.fbx")]
    [InlineData(".calc (calculation export)", "--convert", "a.bvh", "b.fbx")]
    [InlineData(".svg", "--plot", "a.bvh", "b.png")]
    [InlineData("--diagnose", "--record", "take", "--diagnose")]
    [InlineData("--commands", "--record", "take", "--commands")]
    [InlineData("--overwrite", "--overwrite")]
    [InlineData("--colour", "--colour")]
    [InlineData("'b'", "studio", "b")]
    [InlineData("--connect", "studio", "--connect", "other")]
    [InlineData("--udp", "studio", "--udp", "7001")]
    [InlineData("--demo", "udp://:7001", "--demo")]
    [InlineData("--play", "studio", "--play", "take.nmrec")]
    [InlineData("--commands", "studio", "--commands")]
    [InlineData("--info", "studio", "--info", "take.bvh")]
    [InlineData("--diagnose", "studio", "--diagnose", "other")]
    [InlineData("--local-address", "udp://127.0.0.1:7001", "--local-address", "127.0.0.1")]
    [InlineData("--local-address", "--local-address", "127.0.0.1")]
    [InlineData("--local-address", "studio", "--local-address", "office")]
    [InlineData("--udp", "studio", "--allow-sender", "127.0.0.1")]
    [InlineData("--connect", "udp://:7001", "--command-port", "8013")]
    [InlineData("--command-port", "studio:8013", "--command-port", "8013")]
    [InlineData("--calculation-port", "studio", "--calculation-port", "0")]
    [InlineData("--calculation-port", "--calculation-port", "7003")]
    [InlineData("--calculation-port", "--play", "take.nmrec", "--calculation-port", "7003")]
    [InlineData("udp://", "udp://studio")]
    [InlineData("udp://", "udp://:0")]
    [InlineData("http://studio", "http://studio")]
    [InlineData("no such file", "missing.nmrec")]
    [InlineData("no such file", "missing.bvh", "--json")]
    public async Task A_wrong_option_is_one_line_that_says_where_help_is_and_ends_with_2(string named, params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync(args);

        Assert.Equal(2, result.ExitCode);
        Assert.Empty(result.Output);
        string line = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: ", line, StringComparison.Ordinal);
        Assert.Contains(named, line, StringComparison.Ordinal);
        Assert.EndsWith(" neuron-mocap --help lists the options.", line, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--conect", "--connect")]
    [InlineData("--CONNECT", "--connect")]
    [InlineData("-connect", "--connect")]
    [InlineData("--diagnos", "--diagnose")]
    [InlineData("--dianose=5", "--diagnose")]
    [InlineData("--allow-senders", "--allow-sender")]
    [InlineData("--rec", "--record")]
    [InlineData("--colour", null)]
    [InlineData("--", null)]
    [InlineData("-x", null)]
    public async Task An_unknown_option_is_named_with_the_one_that_was_meant(string typed, string? meant)
    {
        ToolResult result = await ToolRunner.RunAsync("studio", typed, "value");

        Assert.Equal(2, result.ExitCode);
        string line = Assert.Single(result.Error);
        if (meant is not null)
            Assert.Contains($"unknown option {typed}: did you mean {meant}? ", line, StringComparison.Ordinal);
        else
            Assert.DoesNotContain("did you mean", line, StringComparison.Ordinal);
    }

    // Every option that --help lists, so that a new one is looked at, too: with a value that none takes, and without its value.
    [Fact]
    public async Task Every_option_is_named_by_what_is_said_about_it()
    {
        ToolResult help = await ToolRunner.RunAsync("--help");
        string[] options = [.. help.Output.Where(static line => line.StartsWith("  --", StringComparison.Ordinal) && line.Contains('<', StringComparison.Ordinal)).Select(static line => line.Split(' ')[2])];
        Assert.True(options.Length > 20, "The options are not found in the help.");
        foreach (string option in options)
        {
            // Those two may stand without a value.
            bool isOptional = option is "--diagnose" or "--commands";
            foreach (string[] args in (string[][])[[option, "a:b:c", option, "a:b:c"], isOptional ? [option, "a:b:c"] : [option, "--json"]])
            {
                ToolResult result = await ToolRunner.RunAsync(args);
                Assert.Equal(2, result.ExitCode);
                string line = Assert.Single(result.Error);
                Assert.Contains(option, line, StringComparison.Ordinal);
                Assert.DoesNotMatch("(?-i)[a-z][A-Z]", line);
            }
        }
    }

    [Fact]
    public async Task A_file_without_an_option_is_no_server()
    {
        string path = Path.GetTempFileName();
        try
        {
            ToolResult result = await ToolRunner.RunAsync(path);
            Assert.Equal(2, result.ExitCode);
            Assert.Contains($"--play {path}", Assert.Single(result.Error), StringComparison.Ordinal);
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    public async Task Help_names_every_option_and_ends_with_0()
    {
        ToolResult result = await ToolRunner.RunAsync("--help");

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);
        string text = string.Join('\n', result.Output);
        foreach (string option in (string[])["--connect", "--udp", "--allow-sender", "--local-address", "--demo", "--diagnose", "--commands", "--avatar", "--zero-out", "--bvh-header", "--order", "--command-port", "--calculation-port", "--once", "--frames", "--duration", "--json", "--quiet", "--info", "--convert", "--plot", "--resample", "--from", "--to", "--play", "--speed", "--rate", "--loop", "--record", "--record-compress", "--record-size", "--record-time", "--record-files", "--overwrite", "--version"])
            Assert.Contains($"  {option} ", text, StringComparison.Ordinal);

        Assert.Contains("Examples:", text, StringComparison.Ordinal);
    }
}
