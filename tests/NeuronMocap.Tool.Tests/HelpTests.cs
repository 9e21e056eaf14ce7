using System.Text.RegularExpressions;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests;

public sealed partial class HelpTests
{
    [Fact]
    public async Task Help_names_every_verb_and_ends_with_0()
    {
        ToolResult result = await ToolRunner.RunAsync("--help");

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);
        foreach (string verb in CommandLineTests.Verbs.Select(static row => row.Data))
            Assert.Contains(result.Output, line => line.StartsWith($"  {verb} ", StringComparison.Ordinal));

        Assert.Contains("Examples:", result.Output);
        Assert.Contains("Exit codes:", result.Output);
    }

    [Theory]
    [MemberData(nameof(CommandLineTests.Verbs), MemberType = typeof(CommandLineTests))]
    public async Task The_help_of_every_verb_has_examples_that_parse_and_exit_codes(string verb)
    {
        using var streams = new StandardStreams(Stream.Null, TextWriter.Null, IsTerminal: false);
        ToolResult result = await ToolRunner.RunAsync(verb, "--help");

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);
        Assert.Contains("Exit codes:", result.Output);
        string[] examples = [.. result.Output.SkipWhile(static line => line != "Examples:").Skip(1).TakeWhile(static line => line.StartsWith("  ", StringComparison.Ordinal))];
        Assert.NotEmpty(examples);
        foreach (string example in examples)
        {
            // The text after the words is the meaning. > and >> belong to the shell.
            string[] words = example.Trim().Split("  ")[0].Split('>')[0].Split(' ', StringSplitOptions.RemoveEmptyEntries);
            Assert.Equal(["neuron-mocap", verb], words[..2]);

            Assert.Null(UsageFault.Find(CommandLine.Create(streams, CancellationToken.None).Parse(words[1..]), words[1..]));
        }
    }

    [Theory]
    [InlineData("watch", "--allow-sender", "--local-address", "--order", "--command-port", "--calculation-port", "--once", "--frames", "--duration", "--json", "--quiet", "--speed", "--rate", "--loop", "--record", "--record-compress", "--record-size", "--record-time", "--record-files", "--export", "--export-avatar", "--overwrite")]
    [InlineData("diagnose", "--json", "--quiet", "--duration", "--allow-sender", "--local-address", "--command-port", "--calculation-port", "--order")]
    [InlineData("play", "--speed", "--rate", "--loop", "--json", "--quiet", "--frames", "--duration", "--order", "--export", "--overwrite")]
    [InlineData("info", "--json", "--rate", "--avatar", "--order")]
    [InlineData("convert", "--from", "--to", "--resample", "--order", "--output-order", "--avatar", "--rate", "--overwrite")]
    [InlineData("plot", "--from", "--to", "--order", "--avatar", "--rate", "--overwrite")]
    [InlineData("command", "--avatar", "--json")]
    [InlineData("relay", "--json", "--quiet", "--commands", "--duration", "--once", "--overwrite", "--pose-rate", "--pose-scale", "--vmc-move", "--osc-space", "--command-port", "--calculation-port", "--speed", "--rate", "--loop")]
    [InlineData("simulate", "--port", "--bvh", "--calc", "--play", "--speed", "--udp", "--calculation-port", "--command-port", "--bind")]
    public async Task The_options_that_scripts_rely_on_exist(string verb, params string[] options)
    {
        ToolResult result = await ToolRunner.RunAsync(verb, "--help");
        foreach (string option in options)
            Assert.Contains(result.Output, line => line.StartsWith($"  {option} ", StringComparison.Ordinal) || line.StartsWith($"  {option}, ", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("diagnose", "a file", "r record")]
    [InlineData("play", "r record", "freeze", "command channel", "calculation export", "the connection")]
    [InlineData("watch", "calculation export")]
    public async Task Help_offers_nothing_that_the_verb_refuses(string verb, params string[] refused)
    {
        string help = string.Join('\n', (await ToolRunner.RunAsync(verb, "--help")).Output);
        foreach (string words in refused)
            Assert.DoesNotContain(words, help, StringComparison.Ordinal);
    }

    // --order is the rotation order of a stream. What convert writes has another option.
    [Theory]
    [InlineData("watch")]
    [InlineData("play")]
    [InlineData("info")]
    [InlineData("plot")]
    [InlineData("convert")]
    public async Task One_option_has_one_meaning(string verb)
    {
        ToolResult help = await ToolRunner.RunAsync(verb, "--help");
        string line = Assert.Single(help.Output, static line => line.StartsWith("  --order ", StringComparison.Ordinal));
        Assert.DoesNotContain("to write", line, StringComparison.Ordinal);
        Assert.DoesNotContain(help.Output, static line => line.Contains("--input-order", StringComparison.Ordinal));
    }

    [Fact]
    public async Task The_command_port_of_the_simulator_has_the_name_that_watch_uses()
    {
        ToolResult help = await ToolRunner.RunAsync("simulate", "--help");
        Assert.Contains(help.Output, static line => line.StartsWith("  --command-port, --commands [<PORT>]", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData(40)]
    [InlineData(80)]
    public async Task Help_on_a_terminal_fits_into_its_lines(int columns)
    {
        foreach (string verb in CommandLineTests.Verbs.Select(static row => row.Data))
        {
            ToolResult result = await ToolRunner.RunOnTerminalAsync(columns, verb, "--help");
            Assert.Equal(0, result.ExitCode);
            Assert.DoesNotContain(result.Output, line => Escapes().Replace(line, string.Empty).Length > columns);
        }
    }

    [GeneratedRegex("\\e\\[[0-9;]*m", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Escapes();
}
