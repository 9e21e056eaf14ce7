using System.Text.Json;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Files;

/// <summary>A script that runs over many files learns which one failed.</summary>
public sealed class FaultyFileNameTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("This is not a take of the 59 bones", "joints.bvh", "out.nmrec")]
    [InlineData("The file holds a skeleton but no frames.", "skeleton.bvh", "out.svg")]
    [InlineData("The file holds a skeleton but no frames.", "skeleton.bvh", "out.calc")]
    [InlineData("It has no motion frame with the 59 bones.", "silent.nmrec", "out.bvh")]
    [InlineData("line 1, column 1: The file has no HIERARCHY", "broken.bvh", "out.bvh")]
    [InlineData("No frames remain: ", "take.bvh", "out.bvh", "--from", "9")]
    public async Task The_sentence_begins_with_the_name_of_the_file(string said, string name, string output, params string[] options)
    {
        await WriteAsync();
        ToolResult result = await ToolRunner.RunAsync([output.EndsWith(".svg", StringComparison.Ordinal) ? "plot" : "convert", _folder[name], _folder[output], .. options]);

        Assert.Equal(1, result.ExitCode);
        Assert.StartsWith($"neuron-mocap: '{_folder[name]}': {said}", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.False(File.Exists(_folder[output]));
    }

    [Fact]
    public async Task A_sentence_about_an_option_stays_as_it_is()
    {
        await WriteAsync();
        ToolResult result = await ToolRunner.RunAsync("convert", _folder["take.bvh"], _folder["out.csv"], "--output-order", "XYZ");
        Assert.StartsWith("neuron-mocap: --output-order: ", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_simulator_names_the_file()
    {
        string path = _folder.Write("joints.bvh", Takes.TwoJoints);
        ToolResult result = await ToolRunner.RunAsync("simulate", "--port", "0", "--bvh", path);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains($"--bvh: '{path}': This is not a take of the 59 bones", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Json_has_a_line_for_every_file()
    {
        await WriteAsync();
        string[] names = ["take.bvh", "missing.bvh", "broken.bvh", "joints.bvh"];
        ToolResult result = await ToolRunner.RunAsync(["info", "--json", .. names.Select(name => _folder[name])]);

        Assert.Equal(1, result.ExitCode);
        Assert.Equal(2, result.Error.Length);
        JsonElement[] lines = [.. result.Output.Select(static line => JsonDocument.Parse(line).RootElement)];
        Assert.Equal(names, lines.Select(static line => line.GetProperty("file").GetString()));
        Assert.All(lines, static line => Assert.Equal("info", line.GetProperty("type").GetString()));
        Assert.Equal([false, true, true, false], lines.Select(static line => line.TryGetProperty("error", out _)));
        Assert.Equal($"'{_folder["missing.bvh"]}' does not exist.", lines[1].GetProperty("error").GetString());
    }

    public void Dispose() => _folder.Dispose();

    private async Task WriteAsync()
    {
        Takes.Actor(10).Save(_folder["take.bvh"]);
        _folder.Write("joints.bvh", Takes.TwoJoints);
        _folder.Write("broken.bvh", "MOTION\nFrames: 1\n");
        string text = await File.ReadAllTextAsync(_folder["take.bvh"], TestContext.Current.CancellationToken);
        _folder.Write("skeleton.bvh", text[..text.IndexOf("MOTION", StringComparison.Ordinal)]);
        using RecordingWriter silent = RecordingWriter.Create(_folder["silent.nmrec"], RecordingMetadata.Empty);
        silent.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "local", "remote"));
    }
}
