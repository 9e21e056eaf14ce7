using System.Globalization;
using System.Numerics;
using System.Xml.Linq;
using NeuronMocap.Bvh;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using static NeuronMocap.Tool.Tests.Plot.Drawing;

namespace NeuronMocap.Tool.Tests.Plot;

public sealed class PlotTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public static TheoryData<float, bool, int> AbsurdValues
    {
        get
        {
            var data = new TheoryData<float, bool, int>();
            foreach (float value in (float[])[1e12f, 1e38f, float.MaxValue, float.NaN, float.PositiveInfinity, float.Epsilon])
            {
                foreach (int channel in (int[])[-1, 0, 1, 2, 3, 30])
                {
                    data.Add(value, false, channel);
                    data.Add(value, true, channel);
                }
            }

            return data;
        }
    }

    [Fact]
    public async Task A_damaged_file_is_drawn_and_its_faults_are_reported()
    {
        ToolResult result = await ToolRunner.RunAsync("plot", await WriteDamagedAsync(), _folder["bad.svg"]);
        Assert.Equal(0, result.ExitCode);
        Assert.True(File.Exists(_folder["bad.svg"]));
        string line = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: bad.bvh: ", line, StringComparison.Ordinal);
        Assert.Contains("; 1 row left out; 1 warning: ", line, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_damaged_file_that_is_not_drawn_has_one_line()
    {
        ToolResult result = await ToolRunner.RunAsync("plot", await WriteDamagedAsync(), _folder["bad.svg"], "--from", "1000");
        Assert.Equal(1, result.ExitCode);
        Assert.DoesNotContain("left out", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_straight_walk_gives_a_straight_path_with_an_even_speed()
    {
        Takes.StraightWalk().Save(_folder["walk.bvh"]);
        XElement svg = await Drawing.PlotAsync(_folder, "walk.bvh");

        (double X, double Y)[] path = Points(svg, "path");
        Assert.True(path.Length > 2);
        Assert.All(path, point => Assert.Equal(path[0].X, point.X, 0.011));
        Assert.True(path[^1].Y > path[0].Y, "Z does not grow downwards.");

        // A constant curve is a horizontal line, and 1 m/s is at the height of the label 1.0.
        (double X, double Y)[] speed = Points(svg, "hips");
        XElement label = Assert.Single(svg.Elements(Svg + "text"), text => text.Value is "1.0" && Number(text, "x") > 490 && Number(text, "y") is > 680 and < 760);
        Assert.All(speed, point => Assert.Equal(Number(label, "y") - 4, point.Y, 0.05));
    }

    [Fact]
    public async Task Everything_is_finite_and_inside_the_drawing()
    {
        Takes.Actor(600).Save(_folder["actor.bvh"]);
        XElement svg = await Drawing.PlotAsync(_folder, "actor.bvh");

        Assert.Equal("actor.bvh", svg.Element(Svg + "title")!.Value);
        Assert.Contains(svg.Elements(Svg + "text"), static text => text.Value.Contains("10.00 s  ·  600 frames at 60 Hz", StringComparison.Ordinal));
        AssertInside(svg);
        Assert.True(Points(svg, "front").Length > 8 * 50);
        Assert.True(Points(svg, "feet").Length > 100);
        Assert.NotEmpty(svg.Descendants(Svg + "g").Single(static group => group.Attribute("id")!.Value is "steps").Elements());
    }

    [Fact]
    public async Task The_same_take_gives_the_same_bytes_in_any_culture()
    {
        Takes.Actor(100).Save(_folder["actor.bvh"]);
        await Drawing.PlotAsync(_folder, "actor.bvh");
        byte[] first = await ReadAsync("actor.svg");
        File.Delete(_folder["actor.svg"]);
        CultureInfo culture = CultureInfo.CurrentCulture;
        var commas = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        commas.NumberFormat.NumberDecimalSeparator = ",";
        CultureInfo.CurrentCulture = commas;
        try
        {
            await Drawing.PlotAsync(_folder, "actor.bvh");
        }
        finally
        {
            CultureInfo.CurrentCulture = culture;
        }

        Assert.Equal(first, await ReadAsync("actor.svg"));
    }

    [Fact]
    public async Task A_long_take_keeps_its_peaks_in_a_small_picture()
    {
        const int Peak = 12_345;
        Takes.Neuron(30_000, static (frame, pose) => Takes.Move(pose, new Vector3(MathF.Sin(frame / 50f), frame == Peak ? 40 : 0, frame % 997 / 10f)))
            .Save(_folder["long.bvh"]);
        XElement svg = await Drawing.PlotAsync(_folder, "long.bvh");

        Assert.InRange(new FileInfo(_folder["long.svg"]).Length, 10_000, 400_000);
        AssertInside(svg);
        Assert.InRange(Points(svg, "feet").Min(static point => point.Y), 570, 600);
    }

    [Fact]
    public async Task Values_that_are_not_finite_leave_holes()
    {
        BvhDocument take = Takes.Neuron(100, static (frame, pose) =>
            Takes.Move(pose, frame is >= 40 and < 60 or 99 ? new Vector3(float.NaN, 0, float.PositiveInfinity) : new Vector3(frame, 0, 0)));
        take.Save(_folder["holes.bvh"]);
        AssertInside(await Drawing.PlotAsync(_folder, "holes.bvh"));
    }

    // A value that no person reaches: in one frame or in all, in one channel or in all.
    [Theory]
    [MemberData(nameof(AbsurdValues))]
    public async Task Absurd_values_end_with_a_picture_of_the_usual_size(float value, bool inAllFrames, int channel)
    {
        BvhDocument take = Takes.Actor(20);
        float[] values = [.. Enumerable.Range(0, take.FrameCount).SelectMany(frame => take.GetValues(frame).ToArray())];
        for (int i = 0; i < values.Length; i++)
        {
            bool isHit = channel < 0 || i % take.ChannelCount == channel;
            if (isHit && (inAllFrames || i / take.ChannelCount == 7))
                values[i] = (i & 1) == 0 ? value : -value;
        }

        new BvhDocument(take.Hierarchy, take.FrameTime, values).Save(_folder["absurd.bvh"]);
        AssertInside(await Drawing.PlotAsync(_folder, "absurd.bvh"));
        Assert.InRange(new FileInfo(_folder["absurd.svg"]).Length, 1_000, 400_000);
        Assert.Equal(["absurd.bvh", "absurd.svg"], _folder.Names);
    }

    [Theory]
    [InlineData("0")]
    [InlineData("1e9")]
    [InlineData("3600")]
    [InlineData("1e-6")]
    [InlineData("-1")]
    [InlineData("NaN")]
    public async Task Absurd_frame_times_end_with_a_picture(string time)
    {
        _folder.Write("joints.bvh", Takes.TwoJoints.Replace("0.04", time, StringComparison.Ordinal));
        AssertInside(await Drawing.PlotAsync(_folder, "joints.bvh"));
        Takes.Actor(20).Save(_folder["actor.bvh"]);
        string text = await File.ReadAllTextAsync(_folder["actor.bvh"], TestContext.Current.CancellationToken);
        _folder.Write("actor.bvh", text.Replace("0.016667", time, StringComparison.Ordinal));
        AssertInside(await Drawing.PlotAsync(_folder, "actor.bvh"));
    }

    [Fact]
    public async Task A_skeleton_of_absurd_size_ends_with_a_picture()
    {
        _folder.Write("joints.bvh", Takes.TwoJoints.Replace("0 0 2", "-3e38 3e38 3e38", StringComparison.Ordinal).Replace("1 -10 0", "3e38 -3e38 3e38", StringComparison.Ordinal));
        AssertInside(await Drawing.PlotAsync(_folder, "joints.bvh"));
        _folder.Write("tiny.bvh", Takes.TwoJoints.Replace("10", "1e-38", StringComparison.Ordinal).Replace("0 0 2", "0 0 1e-40", StringComparison.Ordinal));
        AssertInside(await Drawing.PlotAsync(_folder, "tiny.bvh"));
    }

    [Fact]
    public async Task A_skeleton_without_frames_is_reported_and_leaves_nothing()
    {
        _folder.Write("none.bvh", Takes.TwoJoints[..Takes.TwoJoints.IndexOf("0 10 0 0", StringComparison.Ordinal)]);
        ToolResult result = await ToolRunner.RunAsync("plot", _folder["none.bvh"], _folder["none.svg"]);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("no frames", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Equal(["none.bvh"], _folder.Names);
    }

    [Fact]
    public async Task An_unwritable_picture_is_named()
    {
        Takes.Actor(2).Save(_folder["a.bvh"]);
        ToolResult result = await ToolRunner.RunAsync("plot", _folder["a.bvh"], Path.Combine(_folder["nowhere"], "a.svg"));
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("a.svg", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.DoesNotContain("part", result.Error[0].Replace("part of the path", "", StringComparison.Ordinal), StringComparison.Ordinal);
    }

    [Fact]
    public async Task One_frame_is_enough()
    {
        Takes.Actor(1).Save(_folder["one.bvh"]);
        AssertInside(await Drawing.PlotAsync(_folder, "one.bvh"));
    }

    [Fact]
    public async Task Any_skeleton_can_be_drawn()
    {
        _folder.Write("joints.bvh", Takes.TwoJoints);
        XElement svg = await Drawing.PlotAsync(_folder, "joints.bvh");

        AssertInside(svg);
        Assert.Contains(svg.Elements(Svg + "text"), static text => text.Value.Contains("units", StringComparison.Ordinal));
        Assert.Contains(svg.Descendants(Svg + "path"), static path => path.Attribute("stroke")?.Value is "#0072b2");
    }

    [Fact]
    public async Task A_part_can_be_drawn()
    {
        Takes.StraightWalk().Save(_folder["walk.bvh"]);
        XElement svg = await Drawing.PlotAsync(_folder, "walk.bvh", "--from", "0.5", "--to", "1.5");
        Assert.Contains(svg.Elements(Svg + "text"), static text => text.Value.Contains("1.00 s  ·  60 frames", StringComparison.Ordinal));
    }

    [Fact]
    public async Task An_existing_picture_is_kept_unless_overwritten()
    {
        Takes.Actor(2).Save(_folder["a.bvh"]);
        _folder.Write("a.svg", "mine");
        ToolResult kept = await ToolRunner.RunAsync("plot", _folder["a.bvh"], _folder["a.svg"]);
        Assert.Equal(1, kept.ExitCode);
        Assert.Contains("--overwrite", Assert.Single(kept.Error), StringComparison.Ordinal);
        Assert.Equal("mine", await File.ReadAllTextAsync(_folder["a.svg"], TestContext.Current.CancellationToken));

        ToolResult replaced = await ToolRunner.RunAsync("plot", _folder["a.bvh"], _folder["a.svg"], "--overwrite");
        Assert.Equal(0, replaced.ExitCode);
        Assert.Equal(["a.bvh", "a.svg"], _folder.Names);
        Assert.StartsWith("<?xml", await File.ReadAllTextAsync(_folder["a.svg"], TestContext.Current.CancellationToken), StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Dispose();

    private Task<byte[]> ReadAsync(string name) => File.ReadAllBytesAsync(_folder[name], TestContext.Current.CancellationToken);

    // Its last row is too short.
    private async Task<string> WriteDamagedAsync()
    {
        Takes.StraightWalk().Save(_folder["walk.bvh"]);
        string text = await File.ReadAllTextAsync(_folder["walk.bvh"], TestContext.Current.CancellationToken);
        return _folder.Write("bad.bvh", text.TrimEnd() + "\n1 2 3\n");
    }
}
