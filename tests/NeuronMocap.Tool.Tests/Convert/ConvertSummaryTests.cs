using NeuronMocap.Tool.Tests.Files;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

public sealed class ConvertSummaryTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Fact]
    public async Task A_clean_conversion_is_summarized()
    {
        Takes.Actor(120).Save(_folder["a.bvh"]);
        Assert.Equal(
            "neuron-mocap: b.bvh: 120 frames, 2.000 s at 60 Hz; no gaps; no rows left out; no warnings.",
            await ConvertAsync(_folder["a.bvh"], _folder["b.bvh"]));
        Assert.Equal(
            "neuron-mocap: b.nmrec: 120 frames, 2.000 s at 60 Hz; no gaps; no rows left out; no warnings.",
            await ConvertAsync(_folder["a.bvh"], _folder["b.nmrec"]));
        Assert.StartsWith(
            "neuron-mocap: c.nmrec: 120 frames, 1.983 s; no gaps; no rows left out; no warnings.",
            await ConvertAsync(_folder["b.nmrec"], _folder["c.nmrec"]),
            StringComparison.Ordinal);
    }

    [Fact]
    public async Task Bones_with_a_prefix_are_found_and_other_joints_are_reported()
    {
        Takes.Actor(20).Save(_folder["actor.bvh"]);
        _folder.Write("robot.bvh", Takes.Robot(Takes.Actor(20)));
        foreach (string kind in (string[])["csv", "glb", "nmrec", "bin", "calc"])
        {
            await ConvertAsync(_folder["actor.bvh"], _folder[$"actor.{kind}"]);
            Assert.Contains("1 other joint (Prop1)", await ConvertAsync(_folder["robot.bvh"], _folder[$"robot.{kind}"]), StringComparison.Ordinal);
        }

        Assert.Equal(await RowsAsync("actor.csv"), await RowsAsync("robot.csv"));
        Assert.Equal(await File.ReadAllBytesAsync(_folder["actor.bin"], Token), await File.ReadAllBytesAsync(_folder["robot.bin"], Token));
        Assert.EndsWith("no warnings.", await ConvertAsync(_folder["robot.bvh"], _folder["copy.bvh"]), StringComparison.Ordinal);
        Assert.Contains("ROOT Prop1", await File.ReadAllTextAsync(_folder["copy.bvh"], Token), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_cut_BVH_file_is_reported()
    {
        Takes.Actor(358).Save(_folder["whole.bvh"]);
        string[] lines = await File.ReadAllLinesAsync(_folder["whole.bvh"], Token);
        int row = 1 + Array.FindIndex(lines, static line => line.StartsWith("Frame Time", StringComparison.Ordinal));
        string cut = string.Join("\r\n", lines[..(row + 163)]) + "\r\n" + lines[row + 163][..200];
        _folder.Write("cut.bvh", cut);
        foreach (string output in (string[])["a.bvh", "a.nmrec", "a.calc", "a.bin"])
        {
            string summary = await ConvertAsync(_folder["cut.bvh"], _folder[output]);
            Assert.Contains(": 163 frames, ", summary, StringComparison.Ordinal);
            Assert.Matches(@"; 1 row left out; 2 warnings: \(1\) .*, \(2\) ", summary);
            Assert.Contains("The file declares '358' frames but has 163 rows", summary, StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task A_row_left_out_before_others_shifts_them_which_is_reported()
    {
        Takes.Actor(20).Save(_folder["whole.bvh"]);
        string[] lines = await File.ReadAllLinesAsync(_folder["whole.bvh"], Token);
        int row = 1 + Array.FindIndex(lines, static line => line.StartsWith("Frame Time", StringComparison.Ordinal));
        lines[row + 5] = lines[row + 5].Replace('.', ',');
        lines[row + 6] = lines[row + 6].Replace('.', ',');
        _folder.Write("bad.bvh", string.Join("\n", lines));
        foreach (string output in (string[])["a.bvh", "a.nmrec", "a.calc", "a.csv", "a.glb"])
        {
            string summary = await ConvertAsync(_folder["bad.bvh"], _folder[output]);
            Assert.Contains(": 18 frames, ", summary, StringComparison.Ordinal);
            Assert.Contains("; 2 rows left out; 4 warnings: (1) 2 rows left out before others, so later frames come earlier than in the take, (2) ", summary, StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task A_damaged_recording_is_reported_for_every_output()
    {
        Takes.Actor(3000).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        byte[] bytes = await File.ReadAllBytesAsync(_folder["take.nmrec"], Token);
        bytes[bytes.Length / 2] ^= 0x55;
        await File.WriteAllBytesAsync(_folder["bad.nmrec"], bytes, Token);
        foreach (string output in (string[])["a.bvh", "a.nmrec", "a.bin"])
        {
            string summary = await ConvertAsync(_folder["bad.nmrec"], _folder[output]);
            Assert.Contains("checksum", summary, StringComparison.Ordinal);
            Assert.Contains("1 gap", summary, StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task A_cut_calculation_export_is_reported()
    {
        Takes.Actor(50, rate: 120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        string text = await File.ReadAllTextAsync(_folder["take.calc"], Token);
        _folder.Write("cut.calc", text[..(text.Length / 2)]);
        foreach (string output in (string[])["a.calc", "a.nmrec", "a.bvh"])
            Assert.Contains("; 1 row left out; 1 warning: ", await ConvertAsync(_folder["cut.calc"], _folder[output]), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Only_a_missing_rate_is_a_warning()
    {
        Takes.Actor(50, rate: 120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.bin"]);
        Assert.Contains("120 Hz, is assumed", await ConvertAsync(_folder["take.bin"], _folder["d.nmrec"]), StringComparison.Ordinal);
        Assert.Contains("no warnings", await ConvertAsync(_folder["take.bin"], _folder["e.nmrec"], "--rate", "60"), StringComparison.Ordinal);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        string text = await File.ReadAllTextAsync(_folder["take.calc"], Token);
        _folder.Write("bare.calc", text[(text.IndexOf('\n') + 1)..]);

        Assert.Contains("no warnings", await ConvertAsync(_folder["take.calc"], _folder["a.nmrec"]), StringComparison.Ordinal);
        Assert.Contains("120 Hz is assumed", await ConvertAsync(_folder["bare.calc"], _folder["b.nmrec"]), StringComparison.Ordinal);
        Assert.Contains("no warnings", await ConvertAsync(_folder["bare.calc"], _folder["c.nmrec"], "--rate", "60"), StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Dispose();

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    private async Task<string[]> RowsAsync(string table) =>
        [.. (await File.ReadAllLinesAsync(_folder[table], Token)).Where(static line => !line.StartsWith('#'))];
}
