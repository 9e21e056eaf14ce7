using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Tests.Gltf;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Parts of a recording that has calculation data only.</summary>
public sealed class CalculationPartTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_part_without_motion_has_the_body_of_the_whole_take()
    {
        // The actor stands still after three seconds.
        await RecordAsync(300, stop: 180);
        await ConvertAsync(_folder["rows.nmrec"], _folder["whole.bvh"]);
        Assert.Contains(
            ": 18 frames, 0.300 s at 60 Hz; ", await ConvertAsync(_folder["rows.nmrec"], _folder["part.bvh"], "--from", "4", "--to", "4.3"), StringComparison.Ordinal);
        await ConvertAsync(_folder["rows.nmrec"], _folder["whole.glb"]);
        await ConvertAsync(_folder["rows.nmrec"], _folder["part.glb"], "--from", "4", "--to", "4.3");

        BvhDocument whole = BvhDocument.Load(_folder["whole.bvh"]), part = BvhDocument.Load(_folder["part.bvh"]);
        Assert.Equal(whole.Hierarchy.Joints.Select(static joint => joint.Offset), part.Hierarchy.Joints.Select(static joint => joint.Offset));
        TakeComparison.AssertSamePoses(whole, part, static frame => 240 + frame);
        float distance = GlbTake.Distance(
            GlbFile.Parse(File.ReadAllBytes(_folder["whole.glb"])).Joints(4), GlbFile.Parse(File.ReadAllBytes(_folder["part.glb"])).Joints(0));
        Assert.InRange(distance, 0, 0.001f);
    }

    [Theory]
    [InlineData("part.bvh")]
    [InlineData("part.glb")]
    [InlineData("part.calc")]
    public async Task A_part_of_one_row_has_the_rate_of_the_stream(string output)
    {
        await RecordAsync(120, stop: 120);
        Assert.Contains(
            ": 1 frame, 0.017 s at 60 Hz; ", await ConvertAsync(_folder["rows.nmrec"], _folder[output], "--from", "0.99", "--to", "1.01"), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("convert", "part.bvh")]
    [InlineData("convert", "part.glb")]
    [InlineData("convert", "part.calc")]
    [InlineData("convert", "part.csv")]
    [InlineData("plot", "part.svg")]
    public async Task An_empty_part_says_where_the_take_ends(string verb, string output)
    {
        await RecordAsync(61, stop: 61);
        ToolResult result = await ToolRunner.RunAsync(verb, _folder["rows.nmrec"], _folder[output], "--from", "100");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("No frames remain: the take ends at 1 s.", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.False(File.Exists(_folder[output]));
    }

    private async Task RecordAsync(int frames, int stop)
    {
        var actor = new SyntheticSource(60);
        Takes.Neuron(frames, (frame, pose) => actor.GetPose(Math.Min(frame, stop), pose), displacement: true).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        await ConvertAsync(_folder["take.calc"], _folder["rows.nmrec"]);
    }
}
