using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

public sealed class ConvertRefusalTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("--output-order", "take.bvh", "b.calc")]
    [InlineData("--output-order", "take.calc", "b.calc")]
    [InlineData("--output-order", "take.calc", "b.nmrec")]
    [InlineData("--order", "take.bvh", "b.nmrec")]
    [InlineData("--order", "take.calc", "b.bvh")]
    [InlineData("--order", "take.nmrec", "b.bin")]
    public async Task Orders_without_effect_are_refused(string option, string input, string output)
    {
        Takes.Actor(10).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        ToolResult result = await ToolRunner.RunAsync("convert", _folder[input], _folder[output], option, "XYZ");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains(option, Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.False(File.Exists(_folder[output]));
    }

    [Theory]
    [InlineData("--resample", "60")]
    [InlineData("--output-order", "XYZ")]
    [InlineData("--avatar", "0")]
    public async Task Options_that_would_change_copied_bytes_are_refused(string option, string value)
    {
        Takes.Actor(2).Save(_folder["a.bvh"]);
        await ConvertAsync(_folder["a.bvh"], _folder["a.nmrec"]);
        ToolResult result = await ToolRunner.RunAsync("convert", _folder["a.nmrec"], _folder["b.nmrec"], option, value);

        Assert.Equal(1, result.ExitCode);
        Assert.Contains(option, Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Equal(["a.bvh", "a.nmrec"], _folder.Names);
    }

    [Fact]
    public async Task Wrong_names_and_options_end_with_2()
    {
        Takes.Actor(2).Save(_folder["a.bvh"]);
        foreach (string[] args in (string[][])
            [
                ["convert", _folder["a.bvh"], _folder["a.fbx"]],
                ["convert", _folder["a.bvh"]],
                ["convert", _folder["a.bvh"], _folder["b.bvh"], "--json"],
                ["convert", _folder["a.bvh"], _folder["b.bvh"], "--resample", "0"],
                ["convert", _folder["a.bvh"], _folder["b.bvh"], "--from", "2", "--to", "1"],
                ["convert", _folder["a.bvh"], _folder["b.bvh"], "--once"],
                ["convert", _folder["a.bvh"], _folder["b.bvh"], _folder["c.bvh"]],
                ["plot", _folder["a.bvh"], _folder["a.png"]],
                ["plot", _folder["a.bvh"], _folder["a.svg"], "--resample", "60"],
                ["info", _folder["a.bvh"], "--overwrite"],
                ["info", _folder["a.bvh"], "--quiet"],
            ])
        {
            ToolResult result = await ToolRunner.RunAsync(args);
            Assert.True(result.ExitCode == 2, string.Join(' ', args));
            Assert.EndsWith($"neuron-mocap {args[0]} --help lists the options.", Assert.Single(result.Error), StringComparison.Ordinal);
        }

        Assert.Equal(["a.bvh"], _folder.Names);
    }

    [Theory]
    [InlineData("")]
    [InlineData("nothing that anybody knows")]
    public async Task An_unreadable_file_ends_with_1_and_leaves_nothing(string content)
    {
        _folder.Write("a.bvh", content);
        ToolResult result = await ToolRunner.RunAsync("convert", _folder["a.bvh"], _folder["b.nmrec"]);

        Assert.Equal(1, result.ExitCode);
        Assert.Contains("a.bvh", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Equal(["a.bvh"], _folder.Names);
    }

    [Fact]
    public async Task A_part_after_the_end_is_reported_and_leaves_nothing()
    {
        Takes.Actor(60).Save(_folder["a.bvh"]);
        await ConvertAsync(_folder["a.bvh"], _folder["a.nmrec"]);
        await ConvertAsync(_folder["a.bvh"], _folder["a.calc"]);
        foreach (string input in (string[])["a.bvh", "a.nmrec", "a.calc"])
        {
            ToolResult result = await ToolRunner.RunAsync("convert", _folder[input], _folder["b" + Path.GetExtension(input)], "--from", "9");
            Assert.Equal(1, result.ExitCode);
            Assert.Contains("No frames remain", Assert.Single(result.Error), StringComparison.Ordinal);
        }

        Assert.Equal(["a.bvh", "a.calc", "a.nmrec"], _folder.Names);
    }

    [Theory]
    [InlineData(".bvh")]
    [InlineData(".nmrec")]
    [InlineData(".calc")]
    [InlineData(".bin")]
    public async Task Ctrl_C_ends_with_130_and_leaves_nothing(string extension)
    {
        Takes.Actor(10).Save(_folder["a.bvh"]);
        using var streams = new StandardStreams(Stream.Null, TextWriter.Null, IsTerminal: false);
        Assert.Equal(130, await CommandLine.RunAsync(["convert", _folder["a.bvh"], _folder["b" + extension]], streams, new CancellationToken(canceled: true)));
        Assert.Equal(["a.bvh"], _folder.Names);
    }

    public void Dispose() => _folder.Dispose();
}
