using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Arguments;

public sealed class MistypedOptionTests
{
    // Words and file names: with x as the value, the program would start.
    private static readonly string[] TakesAnyWord = ["--record", "--export", "--server", "--bvh", "--calc", "--play"];

    // These options may be repeated.
    private static readonly string[] TakesMany = ["--allow-sender", "--udp"];

    private static readonly string[][] Contexts =
    [
        ["watch"], ["watch", "studio"], ["watch", "demo"], ["watch", "udp://:7012"], ["watch", "a.nmrec"], ["watch", "--record", "a.nmrec"],
        ["watch", "--export", "a.bvh"], ["play", "a.nmrec"], ["diagnose"], ["diagnose", "studio"], ["diagnose", "demo"], ["diagnose", "udp://:7012"],
        ["command", "studio"], ["command", "demo", "bones"], ["convert", "a.bvh", "b.bvh"], ["convert", "a.bvh", "b.bvh", "--to", "3"],
        ["convert", "a.bvh", "b.bvh", "--from", "1"], ["plot", "a.bvh", "b.svg"], ["plot", "a.bvh", "b.svg", "--to", "3"], ["info", "a.bvh"],
        ["info", "a.bvh", "b.bvh"], ["simulate"], ["simulate", "--bvh", "a.bvh"], ["simulate", "--play", "a.nmrec"],
    ];

    // Covers every option that --help lists, so that new options are tested too, together with everything needed for the program to examine it.
    [Fact]
    public async Task Every_option_with_a_wrong_or_a_second_value_is_one_line_and_ends_with_2()
    {
        var options = new Dictionary<string, IReadOnlyList<VerbOption>>(StringComparer.Ordinal);
        foreach (string verb in Contexts.Select(static context => context[0]).Distinct(StringComparer.Ordinal))
            options[verb] = await VerbHelp.ReadAsync(verb);

        Assert.True(options.Values.Sum(static list => list.Count) > 60, "The options are not found in the help.");
        foreach (string[] context in Contexts)
        {
            foreach (string option in options[context[0]].Select(static option => option.Name))
            {
                if (!TakesAnyWord.Contains(option, StringComparer.Ordinal))
                    await AssertRefusedAsync(context[0], [.. context, option, "x"]);
                if (!TakesMany.Contains(option, StringComparer.Ordinal))
                {
                    await AssertRefusedAsync(context[0], [.. context, option, "x", option, "x"]);
                    await AssertRefusedAsync(context[0], [.. context, option, "2", option, "1"]);
                }
            }
        }
    }

    [Theory]
    [InlineData("plot", "a.bvh", "a.svg", "b.svg")]
    [InlineData("convert", "a.bvh", "b.bvh", "c.bvh")]
    [InlineData("convert", "a.bvh")]
    [InlineData("play", "a.nmrec", "b.nmrec")]
    public async Task A_wrong_number_of_files_is_refused(string verb, params string[] args) => await AssertRefusedAsync(verb, [verb, .. args]);

    // An unexpected output stream: it throws an exception that no system stream throws.
    [Fact]
    public async Task A_fault_of_the_program_is_one_sentence_and_ends_with_1()
    {
        using var broken = new BrokenStream();
        ToolResult result = await ToolRunner.RunAsync(broken, ["watch", "demo", "--json", "--frames", "1"]);
        Assert.Equal(1, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: a fault of this program, please report it: InvalidOperationException: Broken. at ", line, StringComparison.Ordinal);
    }

    private static async Task AssertRefusedAsync(string verb, string[] args)
    {
        try
        {
            ToolResult result = await ToolRunner.RunAsync(args);
            Assert.True(result.ExitCode == 2, $"Exit code {result.ExitCode}: {string.Join(' ', args)}");
            Assert.EndsWith($" neuron-mocap {verb} --help lists the options.", Assert.Single(result.Error), StringComparison.Ordinal);
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
