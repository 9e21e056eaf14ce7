using System.Text.Json;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Files;

/// <summary>BVH files whose rows cannot be read, and bytes after the last row.</summary>
public sealed class UnreadableRowsTests : IDisposable
{
    private const string Reason =
        "none of the 3 rows can be read. Line 19, column 3: '10,5' is not a number, because BVH files have decimal points, not commas; the line is skipped.";

    private static readonly string Commas = Takes.TwoJoints.Replace(" 10 0 0 ", " 10,5 0 0 ", StringComparison.Ordinal).Replace("0.04", "0,04", StringComparison.Ordinal);

    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("out.bvh")]
    [InlineData("out.nmrec")]
    [InlineData("out.csv")]
    [InlineData("out.svg")]
    public async Task A_file_without_a_readable_row_replaces_nothing(string name)
    {
        string input = _folder.Write("in.bvh", Commas);
        string output = _folder.Write(name, "good");
        string verb = name.EndsWith(".svg", StringComparison.Ordinal) ? "plot" : "convert";
        ToolResult result = await ToolRunner.RunAsync(verb, input, output, "--overwrite");

        Assert.Equal(1, result.ExitCode);
        Assert.Equal($"neuron-mocap: '{input}': {Reason}", Assert.Single(result.Error));
        Assert.Equal("good", await File.ReadAllTextAsync(output, TestContext.Current.CancellationToken));
    }

    [Fact]
    public async Task Nothing_is_written_for_a_file_without_a_readable_row()
    {
        string input = _folder.Write("in.bvh", Takes.TwoJoints[..Takes.TwoJoints.IndexOf("0 10 0 0", StringComparison.Ordinal)] + "x\n");
        ToolResult result = await ToolRunner.RunAsync("convert", input, _folder["out.bvh"]);

        Assert.Equal((1, $"neuron-mocap: '{input}': the only row cannot be read. Line 19, column 1: 'x' is not a number; the line is skipped."), (result.ExitCode, Assert.Single(result.Error)));
        Assert.Equal(["in.bvh"], _folder.Names);
    }

    [Fact]
    public async Task Info_ends_with_1_without_a_readable_row()
    {
        string input = _folder.Write("in.bvh", Commas);
        ToolResult page = await ToolRunner.RunAsync("info", input);
        Assert.Equal((1, $"neuron-mocap: '{input}': {Reason}"), (page.ExitCode, Assert.Single(page.Error)));
        Assert.Empty(page.Output);

        ToolResult json = await ToolRunner.RunAsync("info", input, "--json");
        Assert.Equal(1, json.ExitCode);
        JsonElement line = JsonDocument.Parse(Assert.Single(json.Output)).RootElement;
        Assert.Equal("in.bvh", line.GetProperty("file").GetString());
        Assert.Equal($"'{input}': {Reason}", line.GetProperty("error").GetString());
    }

    [Theory]
    [InlineData("\u001a", 1)]
    [InlineData("\u001a\r\n", 1)]
    [InlineData("\0", 512)]
    public async Task Bytes_after_the_end_are_not_a_row(string padding, int count)
    {
        string input = _folder.Write("in.bvh", Takes.TwoJoints + string.Concat(Enumerable.Repeat(padding, count)));
        ToolResult result = await ToolRunner.RunAsync("convert", input, _folder["out.bvh"]);

        Assert.Equal((0, "neuron-mocap: out.bvh: 3 frames, 0.120 s at 25 Hz; no gaps; no rows left out; no warnings."), (result.ExitCode, Assert.Single(result.Error)));
    }

    public void Dispose() => _folder.Dispose();
}
