using System.Globalization;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Gltf;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Avatars of several senders with the same number.</summary>
public sealed class SenderTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public SenderTests() => TwoSenders.Record(_folder["take.nmrec"]);

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(null, 0f)]
    [InlineData(0, 0f)]
    [InlineData(1, TwoSenders.SecondX)]
    public async Task A_file_of_one_avatar_holds_that_of_one_sender(int? sender, float x)
    {
        string[] options = sender is { } number ? ["--sender", number.ToString(CultureInfo.InvariantCulture)] : [];

        string summary = await ConvertAsync(_folder["take.nmrec"], _folder["one.bvh"], options);

        Assert.Contains(": 60 frames, ", summary, StringComparison.Ordinal);
        Assert.Contains("60 frames of other avatars", summary, StringComparison.Ordinal);
        var take = new BvhSource(BvhDocument.Load(_folder["one.bvh"]));
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        Assert.Equal(TwoSenders.Frames, take.FrameCount);
        for (int frame = 0; frame < TwoSenders.Frames; frame++)
        {
            take.GetPose(frame, pose);
            Assert.Equal(x, pose[0].Position.X);
        }
    }

    [Fact]
    public async Task A_glb_file_has_a_figure_for_each()
    {
        Assert.Contains(": 120 frames, ", await ConvertAsync(_folder["take.nmrec"], _folder["all.glb"]), StringComparison.Ordinal);
        await ConvertAsync(_folder["take.nmrec"], _folder["ben.glb"], "--sender", "1");

        var all = GlbFile.Parse(await File.ReadAllBytesAsync(_folder["all.glb"]));
        var ben = GlbFile.Parse(await File.ReadAllBytesAsync(_folder["ben.glb"]));
        Assert.Equal(["Anna", "Ben"], all.Names("animations"));
        Assert.Equal(["Ben"], ben.Names("animations"));
        foreach (double time in (double[])[0, 0.4, 0.9])
        {
            Assert.Equal(0, all.Joints(time)[0].X, 1e-4);
            Assert.Equal(3, all.Joints(time, skin: 1, animation: 1)[0].X, 1e-4);
            Assert.Equal(3, ben.Joints(time)[0].X, 1e-4);
        }
    }

    [Fact]
    public async Task The_figures_of_a_glb_file_have_different_colours()
    {
        TwoSenders.Record(_folder["other.nmrec"], firstAvatar: 1);
        await ConvertAsync(_folder["other.nmrec"], _folder["all.glb"]);

        var all = GlbFile.Parse(await File.ReadAllBytesAsync(_folder["all.glb"]));
        string[] materials = [.. all.Json.GetProperty("materials").EnumerateArray().Select(static material => material.GetProperty("pbrMetallicRoughness").GetRawText())];
        Assert.Equal(3, materials.Length);
        Assert.Distinct(materials);
    }

    [Fact]
    public async Task A_table_numbers_the_second_anew()
    {
        Assert.Contains(": 120 frames, ", await ConvertAsync(_folder["take.nmrec"], _folder["all.csv"]), StringComparison.Ordinal);
        await ConvertAsync(_folder["take.nmrec"], _folder["ben.csv"], "--sender", "1");

        var all = new CsvTable(_folder["all.csv"]);
        var ben = new CsvTable(_folder["ben.csv"]);
        Assert.Contains("# avatar 0: Anna", all.Comments);
        Assert.Contains("# avatar 1000: Ben, avatar 0 of sender 1", all.Comments);
        Assert.Contains("# avatar 0: Ben", ben.Comments);
        for (int row = 0; row < TwoSenders.Frames; row++)
        {
            Assert.Equal((0, 0), (all.Number(2 * row, "avatar"), all.Number(2 * row, "Hips_x")));
            Assert.Equal((1000, 3), (all.Number((2 * row) + 1, "avatar"), all.Number((2 * row) + 1, "Hips_x")));
            Assert.Equal((0, 3), (ben.Number(row, "avatar"), ben.Number(row, "Hips_x")));
        }
    }

    [Fact]
    public async Task A_sender_that_is_not_there_is_refused_with_those_that_are()
    {
        ToolResult none = await ToolRunner.RunAsync("convert", _folder["take.nmrec"], _folder["none.bvh"], "--sender", "2");
        ToolResult copy = await ToolRunner.RunAsync("convert", _folder["take.nmrec"], _folder["copy.nmrec"], "--sender", "1");

        Assert.Contains("It has no pose of sender 2; there are 0 (Anna), 0 of sender 1 (Ben).", Assert.Single(none.Error), StringComparison.Ordinal);
        Assert.Contains("--sender: ", Assert.Single(copy.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Info_names_the_second_sender_and_describes_its_avatar()
    {
        ToolResult info = await ToolRunner.RunAsync("info", _folder["take.nmrec"], "--sender", "1");

        Assert.Equal(0, info.ExitCode);
        string page = string.Join('\n', info.Output);
        Assert.Contains("0 Ben of sender 1: 60 motion frames", page, StringComparison.Ordinal);
        Assert.Contains("Take of avatar 0, Ben of sender 1", page, StringComparison.Ordinal);
    }
}
