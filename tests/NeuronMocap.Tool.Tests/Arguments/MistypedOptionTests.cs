using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Arguments;

public sealed class MistypedOptionTests
{
    // Words and names of files: x is one, and the program would begin.
    private static readonly string[] TakesAnyWord = ["--connect", "--diagnose", "--commands", "--play", "--record", "--export", "--info", "--allow-sender"];

    private static readonly string[][] Contexts =
    [
        [], ["studio"], ["--demo"], ["--connect", "studio"], ["--udp", "7012"], ["--play", "a.nmrec"], ["--diagnose"], ["--diagnose", "studio"],
        ["--diagnose", "--demo"], ["--commands"], ["--convert", "a.bvh", "b.bvh"], ["--convert", "a.bvh", "b.bvh", "--to", "3"],
        ["--convert", "a.bvh", "b.bvh", "--from", "1"], ["--plot", "a.bvh", "b.svg"], ["--plot", "a.bvh", "b.svg", "--to", "3"],
        ["--info", "a.bvh"], ["--record", "a.nmrec"], ["--export", "a.bvh"],
    ];

    // Every option that --help lists, so that a new one is looked at, too, beside everything that makes a program look at it.
    [Fact]
    public async Task Every_option_with_a_wrong_or_a_second_value_is_one_line_and_ends_with_2()
    {
        ToolResult help = await ToolRunner.RunAsync("--help");
        string[] options = [.. help.Output.Where(static line => line.StartsWith("  --", StringComparison.Ordinal) && line.Contains('<', StringComparison.Ordinal)).Select(static line => line.Split(' ')[2])];
        Assert.True(options.Length > 20, "The options are not found in the help.");
        foreach (string option in options)
        {
            foreach (string[] context in Contexts)
            {
                if (!TakesAnyWord.Contains(option, StringComparer.Ordinal))
                    await AssertRefusedAsync([.. context, option, "x"]);
                if (!string.Equals(option, "--allow-sender", StringComparison.Ordinal))
                {
                    await AssertRefusedAsync([.. context, option, "x", option, "x"]);
                    await AssertRefusedAsync([.. context, option, "2", option, "1"]);
                }
            }
        }
    }

    [Theory]
    [InlineData("--convert", "a.bvh", "b.bvh", "--convert", "c.bvh", "d.bvh")]
    [InlineData("--convert", "a.bvh", "--convert", "c.bvh", "d.bvh")]
    [InlineData("--plot", "a.bvh", "a.svg", "--plot", "b.bvh", "b.svg")]
    [InlineData("--plot", "a.bvh", "a.svg", "b.svg")]
    [InlineData("--convert", "a.bvh", "b.bvh", "c.bvh")]
    [InlineData("--convert", "a.bvh")]
    public async Task More_or_fewer_files_than_two_are_refused(params string[] args) => await AssertRefusedAsync(args);

    // An output that nobody has thought of: it throws what no stream of a system throws.
    [Fact]
    public async Task A_fault_of_the_program_is_one_sentence_and_ends_with_1()
    {
        using var broken = new BrokenStream();
        ToolResult result = await ToolRunner.RunAsync(broken, ["--demo", "--json", "--frames", "1"]);
        Assert.Equal(1, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: a fault of this program, please report it: InvalidOperationException: Broken. at ", line, StringComparison.Ordinal);
    }

    private static async Task AssertRefusedAsync(string[] args)
    {
        try
        {
            ToolResult result = await ToolRunner.RunAsync(args);
            Assert.True(result.ExitCode == 2, $"Exit code {result.ExitCode}: {string.Join(' ', args)}");
            Assert.EndsWith(" neuron-mocap --help lists the options.", Assert.Single(result.Error), StringComparison.Ordinal);
            Assert.Empty(result.Output);
        }
        catch (InvalidOperationException exception)
        {
            Assert.Fail($"{string.Join(' ', args)}: {exception.Message}");
        }
    }

    private sealed class BrokenStream : MemoryStream
    {
        public override void Write(ReadOnlySpan<byte> buffer) => throw new InvalidOperationException("Broken.");
    }
}
