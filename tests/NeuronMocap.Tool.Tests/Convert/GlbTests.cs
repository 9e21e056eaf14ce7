using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Gltf;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

public sealed class GlbTests : IDisposable
{
    // In millimetres. Angles of a take are rounded.
    private const float SamePlace = 0.1f;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("take.bvh", "b.glb: 120 frames, 2.000 s at 60 Hz; no gaps; no rows left out; no warnings.", "Char00")]
    [InlineData("take.nmrec", "b.glb: 120 frames, 2.000 s at 60 Hz; no gaps; no rows left out; no warnings; not kept: times of arrival.", "Char00")]
    [InlineData("take.calc", "b.glb: 120 frames, 2.000 s at 60 Hz; no gaps; no rows left out; no warnings; not kept: what the sensors measured.", "Char00")]
    public async Task Every_kind_of_take_becomes_a_figure_that_moves(string input, string summary, string name)
    {
        Takes.Actor(120).Save(_folder["take.bvh"]);
        if (input != "take.bvh")
            await ConvertAsync(_folder["take.bvh"], _folder[input]);

        Assert.Equal($"neuron-mocap: {summary}", await ConvertAsync(_folder[input], _folder["b.glb"]));

        GlbFile file = Read("b.glb");
        Assert.Equal([name], file.Names("animations"));
        Assert.Equal(120, file.KeyTimes(0, "Hips").Length);
        await ConvertAsync(_folder[input], _folder["same.bvh"]);
        var take = new BvhSource(BvhDocument.Load(_folder["same.bvh"]));
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        foreach (int frame in (int[])[0, 60, 119])
        {
            take.GetPose(frame, pose);
            Assert.InRange(GlbTake.Distance(GlbTake.Joints(pose), file.Joints(GlbTake.Time(frame).TotalSeconds)), 0, SamePlace);
        }
    }

    [Fact]
    public async Task All_avatars_are_written_unless_one_is_named()
    {
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < 60; frame++)
            {
                recording.Add(frame / 60.0, frame);
                recording.Add((frame / 60.0) + 0.002, frame, avatar: 3, name: "Ben");
                if (frame >= 30)
                    recording.Add((frame / 60.0) + 0.003, frame, avatar: 4, name: "Anna");
            }
        }

        Assert.Contains(": 150 frames, 1.000 s at 60 Hz; ", await ConvertAsync(_folder["take.nmrec"], _folder["all.glb"]), StringComparison.Ordinal);
        string summary = await ConvertAsync(_folder["take.nmrec"], _folder["ben.glb"], "--avatar", "3");
        Assert.Contains("90 frames of other avatars", summary, StringComparison.Ordinal);
        GlbFile all = Read("all.glb"), ben = Read("ben.glb");
        Assert.Equal(["Anna", "Ben", "Anna (2)"], all.Names("animations"));
        Assert.Equal(["Ben"], ben.Names("animations"));
        Assert.Equal(all.KeyTimes(0, "Hips"), all.KeyTimes(1, "Hips", skin: 1));
        Assert.Equal(0.5f, all.KeyTimes(2, "Hips", skin: 2)[0]);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(45)), all.Joints(0.75, skin: 2, animation: 2)), 0, SamePlace);

        ToolResult none = await ToolRunner.RunAsync("convert", _folder["take.nmrec"], _folder["none.glb"], "--avatar", "9");
        Assert.Equal(1, none.ExitCode);
        Assert.Contains("It has no pose of avatar 9; there are 0 (Anna), 3 (Ben), 4 (Anna).", Assert.Single(none.Error), StringComparison.Ordinal);
        Assert.Equal(["all.glb", "ben.glb", "take.nmrec"], _folder.Names);
    }

    [Fact]
    public async Task A_gap_keeps_its_length_and_its_pose()
    {
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < 120; frame++)
                recording.Add((frame / 60.0) + (frame < 60 ? 0 : 3600), frame < 60 ? frame : frame + 100_000);
        }

        string summary = await ConvertAsync(_folder["take.nmrec"], _folder["b.glb"]);

        Assert.Contains(": 120 frames, 3602.000 s at 60 Hz; 1 gap (100,000 frames missing); ", summary, StringComparison.Ordinal);
        GlbFile file = Read("b.glb");
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(59)), file.Joints(1800)), 0, SamePlace);
        Assert.Equal(3600 + (119 / 60.0), file.KeyTimes(0, "Hips")[^1], 0.001);
    }

    [Theory]
    [InlineData(0.5)]
    [InlineData(3)]
    [InlineData(12)]
    public async Task A_pause_keeps_its_length_though_the_numbers_go_on(double pause)
    {
        // The second avatar is a little late, and more so after the pause.
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < 240; frame++)
            {
                double time = 5 + (frame / 60.0) + (frame < 120 ? 0 : pause);
                recording.Add(time, frame);
                recording.Add(time + (frame == 120 ? 0.004 : 0.001), frame, avatar: 1, name: "Ben");
            }
        }

        await ConvertAsync(_folder["take.nmrec"], _folder["b.glb"]);

        GlbFile file = Read("b.glb");
        double[] times = [.. file.KeyTimes(0, "Hips").Select(static time => (double)time)];
        Assert.Equal(119 / 60.0, times[119], 1e-4);
        Assert.Equal((120 / 60.0) + pause, times[^120], 1e-4);
        Assert.Equal((239 / 60.0) + pause, times[^1], 1e-4);
        Assert.Equal(file.KeyTimes(0, "Hips"), file.KeyTimes(1, "Hips", skin: 1));
    }

    [Fact]
    public async Task A_network_that_stalls_is_no_pause()
    {
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < 600; frame++)
                recording.Add(frame is >= 120 and < 420 ? 7 : frame / 60.0, frame);
        }

        await ConvertAsync(_folder["take.nmrec"], _folder["b.glb"]);

        Assert.Equal(Enumerable.Range(0, 600).Select(static frame => (float)GlbTake.Time(frame).TotalSeconds), Read("b.glb").KeyTimes(0, "Hips"));
    }

    [Fact]
    public async Task A_part_of_a_recording_has_the_frames_that_arrived_in_it()
    {
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < 240; frame++)
            {
                recording.Add(2 + (frame / 60.0) + (frame < 120 ? 0 : 3), frame);
                if (frame >= 120)
                    recording.Add(2 + (frame / 60.0) + 3.001, frame, avatar: 1, name: "Ben");
            }
        }

        string summary = await ConvertAsync(_folder["take.nmrec"], _folder["b.glb"], "--from", "3", "--to", "8");

        Assert.Contains(": 180 frames, 5.000 s at 60 Hz; ", summary, StringComparison.Ordinal);
        GlbFile file = Read("b.glb");
        float[] times = file.KeyTimes(0, "Hips");
        Assert.Equal(0, times[0]);
        Assert.Equal(5 - (1 / 60.0), times[^1], 1e-4);
        Assert.Equal(4, file.KeyTimes(1, "Hips", skin: 1)[0], 1e-4);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(60)), file.Joints(0)), 0, SamePlace);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(120)), file.Joints(4, skin: 1, animation: 1)), 0, SamePlace);

        await ConvertAsync(_folder["take.nmrec"], _folder["early.glb"], "--to", "3.5");
        Assert.Equal(["Anna"], Read("early.glb").Names("animations"));
        ToolResult none = await ToolRunner.RunAsync("convert", _folder["take.nmrec"], _folder["none.glb"], "--from", "5", "--to", "6");
        Assert.Contains("No frames remain: the take ends at 8.98", Assert.Single(none.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Frames_that_arrive_in_bursts_have_even_times()
    {
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < 300; frame++)
                recording.Add(Math.Max(frame, 10 * (frame / 10)) / 60.0, frame);
        }

        await ConvertAsync(_folder["take.nmrec"], _folder["b.glb"]);

        Assert.Equal(Enumerable.Range(0, 300).Select(static frame => (float)GlbTake.Time(frame).TotalSeconds), Read("b.glb").KeyTimes(0, "Hips"));
    }

    [Fact]
    public async Task A_part_begins_at_zero_at_the_rate_that_was_asked_for()
    {
        Takes.Actor(240).Save(_folder["take.bvh"]);
        string summary = await ConvertAsync(_folder["take.bvh"], _folder["b.glb"], "--from", "1", "--to", "3", "--resample", "30", "--key-error", "0.1");

        Assert.Contains(": 60 frames, 2.000 s at 30 Hz; ", summary, StringComparison.Ordinal);
        GlbFile file = Read("b.glb");
        Assert.Equal(0, file.KeyTimes(0, "Hips")[0]);
        Assert.InRange(file.KeyTimes(0, "LeftArm").Length, 3, 59);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(60)), file.Joints(0)), 0, SamePlace);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(120)), file.Joints(1)), 0, 8);
    }

    [Fact]
    public async Task Values_that_are_not_numbers_are_a_warning()
    {
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < 60; frame++)
                recording.Add(frame / 60.0, frame, change: values => values.AsSpan(0, frame == 30 ? 6 : 0).Fill(float.NaN));
        }

        string summary = await ConvertAsync(_folder["take.nmrec"], _folder["b.glb"]);

        Assert.Contains("values that are not numbers", summary, StringComparison.Ordinal);
        Vector3[] joints = Read("b.glb").Joints(0.5);
        Assert.All(joints, static joint => Assert.True(float.IsFinite(joint.Length())));
    }

    [Theory]
    [InlineData(1, "--output-order", "--output-order", "XYZ")]
    [InlineData(1, "No frames remain: the take ends at 1 s.", "--from", "5")]
    [InlineData(2, "--key-error: '46' is not a number of degrees, 0 to 45.", "--key-error", "46")]
    public async Task What_cannot_be_written_leaves_nothing(int code, string message, params string[] options)
    {
        Takes.Actor(60).Save(_folder["take.bvh"]);
        ToolResult result = await ToolRunner.RunAsync(["convert", _folder["take.bvh"], _folder["b.glb"], .. options]);

        Assert.Equal(code, result.ExitCode);
        Assert.Contains(message, Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Equal(["take.bvh"], _folder.Names);
    }

    [Fact]
    public async Task The_option_is_refused_for_other_files_and_a_glb_file_as_input()
    {
        Takes.Actor(10).Save(_folder["take.bvh"]);
        ToolResult result = await ToolRunner.RunAsync("convert", _folder["take.bvh"], _folder["b.bvh"], "--key-error", "1");
        Assert.Equal(2, result.ExitCode);
        Assert.Contains("--key-error is for .glb files.", Assert.Single(result.Error), StringComparison.Ordinal);

        await ConvertAsync(_folder["take.bvh"], _folder["b.glb"]);
        result = await ToolRunner.RunAsync("info", _folder["b.glb"]);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains(".glb' is a GLB file", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Ctrl_C_leaves_nothing()
    {
        Takes.Actor(10).Save(_folder["take.bvh"]);
        using var streams = new StandardStreams(Stream.Null, TextWriter.Null, IsTerminal: false);
        Assert.Equal(130, await CommandLine.RunAsync(["convert", _folder["take.bvh"], _folder["b.glb"]], streams, new CancellationToken(canceled: true)));
        Assert.Equal(["take.bvh"], _folder.Names);
    }

    private GlbFile Read(string name) => GlbFile.Parse(File.ReadAllBytes(_folder[name]));
}
