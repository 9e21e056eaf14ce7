using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Calculation;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Convert;

public sealed class ConvertTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Fact]
    public async Task The_real_take_comes_back_byte_by_byte_and_through_a_recording_value_by_value()
    {
        string take = Fixtures.Require("test-take", "test.bvh");
        await ConvertAsync(take, _folder["same.bvh"]);
        Assert.Equal(await File.ReadAllBytesAsync(take, Token), await File.ReadAllBytesAsync(_folder["same.bvh"], Token));

        await ConvertAsync(take, _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["back.bvh"]);
        AssertSame(BvhDocument.Load(take), BvhDocument.Load(_folder["back.bvh"]));

        await ConvertAsync(take, _folder["take.dat"]);
        await ConvertAsync(_folder["take.dat"], _folder["raw.nmrec"]);
        await ConvertAsync(_folder["raw.nmrec"], _folder["raw.bin"]);
        Assert.Equal(await File.ReadAllBytesAsync(_folder["take.dat"], Token), await File.ReadAllBytesAsync(_folder["raw.bin"], Token));
    }

    [Theory]
    [InlineData("MasterLiuPerformanceChar00.calc")]
    [InlineData("hiphop_up_Char00.calc")]
    [InlineData("salsa_left_Char00.calc")]
    public async Task Real_calculation_exports_come_back_byte_by_byte_and_through_a_recording_value_by_value(string name)
    {
        string take = Fixtures.Require("calc", name);
        await ConvertAsync(take, _folder["same.calc"]);
        Assert.Equal(await File.ReadAllBytesAsync(take, Token), await File.ReadAllBytesAsync(_folder["same.calc"], Token));

        await ConvertAsync(take, _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["back.calc"]);
        AssertSame(CalculationDocument.Load(take), CalculationDocument.Load(_folder["back.calc"]));

        await ConvertAsync(take, _folder["direct.bvh"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["recorded.bvh"]);
        AssertSame(BvhDocument.Load(_folder["direct.bvh"]), BvhDocument.Load(_folder["recorded.bvh"]));
    }

    [Theory]
    [InlineData(true, RotationOrder.YXZ)]
    [InlineData(false, RotationOrder.ZYX)]
    public async Task A_take_and_its_body_come_back_from_a_recording(bool displacement, RotationOrder order)
    {
        Takes.Actor(120, displacement: displacement, order: order).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["back.bvh"]);

        AssertSame(BvhDocument.Load(_folder["take.bvh"]), BvhDocument.Load(_folder["back.bvh"]));
        using RecordingReader recording = RecordingReader.Open(_folder["take.nmrec"]);
        Assert.Equal(order.ToString(), recording.Metadata[RecordingMetadata.RotationOrderKey]);
        Assert.Equal(TimeSpan.FromTicks((long)Math.Round(119 * TimeSpan.TicksPerSecond / 60.0)), recording.Duration);
    }

    // The order of a stream stands in no packet of Axis Neuron: the option tells it, and the values stay what they are.
    [Fact]
    public async Task The_order_of_raw_bytes_is_told_and_kept()
    {
        Takes.Actor(60, order: RotationOrder.XYZ).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.bin"]);
        await ConvertAsync(_folder["take.bin"], _folder["back.bvh"], "--input-order", "xyz");

        Assert.Equal(Values(BvhDocument.Load(_folder["take.bvh"])), Values(BvhDocument.Load(_folder["back.bvh"])));
        Assert.True(BvhSkeletonMap.TryCreate(BvhDocument.Load(_folder["back.bvh"]), out BvhSkeletonMap? map, out _));
        Assert.Equal(RotationOrder.XYZ, map.Format.RotationOrder);
    }

    [Fact]
    public async Task Parts_rates_and_orders_of_BVH_files()
    {
        Takes.Actor(240, rate: 120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["part.bvh"], "--from", "0.5", "--to", "1.5", "--resample", "60", "--order", "ZYX");
        BvhDocument part = BvhDocument.Load(_folder["part.bvh"]);

        Assert.Equal((60, 60.0), (part.FrameCount, part.FrameRate));
        Assert.True(BvhSkeletonMap.TryCreate(part, out BvhSkeletonMap? map, out _));
        Assert.Equal(RotationOrder.ZYX, map.Format.RotationOrder);
        AssertSamePoses(BvhDocument.Load(_folder["take.bvh"]), part, static frame => 60 + (2 * frame));
    }

    [Fact]
    public async Task Any_skeleton_can_be_cut()
    {
        _folder.Write("joints.bvh", Takes.TwoJoints);
        await ConvertAsync(_folder["joints.bvh"], _folder["part.bvh"], "--from", "0.04");
        Assert.Equal([1, 10, 0, 0, 0, 0, 5, 2, 10, 0, 0, 0, 0, 10], Values(BvhDocument.Load(_folder["part.bvh"])));

        ToolResult result = await ToolRunner.RunAsync("convert", _folder["joints.bvh"], _folder["joints.nmrec"]);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("59 bones", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_part_of_a_recording_has_its_bytes_with_their_times()
    {
        Takes.Actor(120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["part.nmrec"], "--from", "1", "--to", "1.5");

        using RecordedFrameReader reader = RecordedFrameReader.Open(_folder["part.nmrec"]);
        var frames = new List<(uint? Index, TimeSpan Time)>();
        while (reader.Read())
            frames.Add((reader.Frame.FrameIndex, reader.Time));

        Assert.Equal(Enumerable.Range(60, 30).Select(static index => (uint?)index), frames.Select(static frame => frame.Index));
        Assert.Equal(TimeSpan.Zero, frames[0].Time);
        Assert.Equal(29 / 60.0, frames[^1].Time.TotalSeconds, 1e-6);
        Assert.Equal(0, reader.GetStatistics().BytesSkipped);
    }

    [Fact]
    public async Task A_recording_of_poses_becomes_a_BVH_file_of_another_rate()
    {
        Takes.Actor(240, rate: 120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["half.bvh"], "--resample", "60", "--from", "1");
        BvhDocument half = BvhDocument.Load(_folder["half.bvh"]);

        Assert.Equal((60, 60.0), (half.FrameCount, half.FrameRate));
        Assert.Equal(Enumerable.Range(0, 60).SelectMany(frame => Row(BvhDocument.Load(_folder["take.bvh"]), 120 + (2 * frame))), Values(half));
    }

    // From 24 to 60 Hz no frame but the first meets one of the take.
    [Fact]
    public async Task Frames_in_between_are_interpolated()
    {
        Takes.StraightWalk(frames: 24, rate: 24).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["more.bvh"], "--resample", "60");
        BvhDocument more = BvhDocument.Load(_folder["more.bvh"]);

        Assert.Equal(58, more.FrameCount);
        for (int frame = 0; frame < more.FrameCount; frame++)
            Assert.Equal(frame / 60f * 100, more.GetFrame(frame)[2], 0.001f);
    }

    // A calculation export has bones' centres and sensors, no joints: they are found again from the motion, those of legs that walk best.
    [Fact]
    public async Task A_take_as_calculation_data_is_nearly_the_same_take()
    {
        Takes.Actor(300, rate: 120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        await ConvertAsync(_folder["take.calc"], _folder["back.bvh"]);

        Vector3[][] expected = Joints(BvhDocument.Load(_folder["take.bvh"]));
        Vector3[][] actual = Joints(BvhDocument.Load(_folder["back.bvh"]));
        Assert.Equal(expected.Length, actual.Length);
        for (Bone bone = Bone.Hips; bone <= Bone.LeftFoot; bone++)
        {
            float farthest = Enumerable.Range(0, expected.Length).Max(frame => Vector3.Distance(expected[frame][(int)bone], actual[frame][(int)bone]));
            Assert.True(farthest < 1, $"{bone} is {farthest} cm from its place.");
        }
    }

    // Rates that no server has, and times that are no round number of ticks.
    [Theory]
    [InlineData(60)]
    [InlineData(90)]
    [InlineData(120)]
    [InlineData(59.94)]
    [InlineData(97.3)]
    [InlineData(23.976023976023978)]
    [InlineData(1000)]
    public async Task Frames_times_and_values_survive_every_way_there_and_back(double rate)
    {
        Takes.Actor(100, rate: rate).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["back.bvh"]);
        AssertSame(BvhDocument.Load(_folder["take.bvh"]), BvhDocument.Load(_folder["back.bvh"]));
        await ConvertAsync(_folder["back.bvh"], _folder["again.nmrec"]);
        AssertSameFrames(_folder["take.nmrec"], _folder["again.nmrec"]);

        await ConvertAsync(_folder["take.nmrec"], _folder["take.calc"]);
        await ConvertAsync(_folder["take.calc"], _folder["calculation.nmrec"]);
        await ConvertAsync(_folder["calculation.nmrec"], _folder["back.calc"]);
        Assert.Equal(await File.ReadAllBytesAsync(_folder["take.calc"], Token), await File.ReadAllBytesAsync(_folder["back.calc"], Token));
        Assert.Equal(Times(_folder["take.nmrec"]), Times(_folder["calculation.nmrec"]));
        await ConvertAsync(_folder["back.calc"], _folder["again.calculation.nmrec"]);
        AssertSameFrames(_folder["calculation.nmrec"], _folder["again.calculation.nmrec"]);

        await ConvertAsync(_folder["take.calc"], _folder["poses.bvh"]);
        Assert.Equal(BvhDocument.Load(_folder["take.bvh"]).FrameTime, BvhDocument.Load(_folder["poses.bvh"]).FrameTime);

        string given = rate.ToString(System.Globalization.CultureInfo.InvariantCulture);
        await ConvertAsync(_folder["take.nmrec"], _folder["take.bin"]);
        await ConvertAsync(_folder["take.bin"], _folder["timed.nmrec"], "--rate", given);
        Assert.Equal(Times(_folder["take.nmrec"]).Select(static time => time / TimeSpan.FromSeconds(1)), Times(_folder["timed.nmrec"]).Select(static time => time / TimeSpan.FromSeconds(1)), new Near(2e-7));
    }

    [Fact]
    public async Task The_order_option_writes_another_order_whatever_the_input_is()
    {
        Takes.Actor(60).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.bin"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        foreach (string input in (string[])["take.bvh", "take.nmrec", "take.bin"])
        {
            string output = _folder[input + ".bvh"];
            await ConvertAsync(_folder[input], output, "--order", "XYZ");
            Assert.True(BvhSkeletonMap.TryCreate(BvhDocument.Load(output), out BvhSkeletonMap? map, out _));
            Assert.Equal(RotationOrder.XYZ, map.Format.RotationOrder);
            AssertSamePoses(BvhDocument.Load(_folder["take.bvh"]), BvhDocument.Load(output), static frame => frame);
        }

        await ConvertAsync(_folder["take.calc"], _folder["yxz.bvh"]);
        await ConvertAsync(_folder["take.calc"], _folder["xyz.bvh"], "--order", "XYZ");
        AssertSamePoses(BvhDocument.Load(_folder["yxz.bvh"]), BvhDocument.Load(_folder["xyz.bvh"]), static frame => frame);

        await ConvertAsync(_folder["take.bvh"], _folder["zyx.nmrec"], "--order", "ZYX");
        await ConvertAsync(_folder["zyx.nmrec"], _folder["zyx.bvh"]);
        AssertSamePoses(BvhDocument.Load(_folder["take.bvh"]), BvhDocument.Load(_folder["zyx.bvh"]), static frame => frame);
    }

    [Theory]
    [InlineData("--order", "take.bvh", "b.calc")]
    [InlineData("--order", "take.calc", "b.calc")]
    [InlineData("--order", "take.calc", "b.nmrec")]
    [InlineData("--input-order", "take.bvh", "b.nmrec")]
    [InlineData("--input-order", "take.calc", "b.bvh")]
    [InlineData("--input-order", "take.nmrec", "b.bin")]
    public async Task Orders_that_would_do_nothing_are_refused(string option, string input, string output)
    {
        Takes.Actor(10).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        ToolResult result = await ToolRunner.RunAsync("convert", _folder[input], _folder[output], option, "XYZ");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains(option, Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.False(File.Exists(_folder[output]));
    }

    [Fact]
    public async Task A_clean_conversion_says_so()
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
    public async Task A_BVH_file_that_was_cut_is_told()
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
            Assert.Contains("'358' frames are announced and 163 rows are there", summary, StringComparison.Ordinal);
        }
    }

    [Fact]
    public async Task A_damaged_recording_is_told_on_every_way()
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
    public async Task A_cut_calculation_export_is_told()
    {
        Takes.Actor(50, rate: 120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        string text = await File.ReadAllTextAsync(_folder["take.calc"], Token);
        _folder.Write("cut.calc", text[..(text.Length / 2)]);
        foreach (string output in (string[])["a.calc", "a.nmrec", "a.bvh"])
            Assert.Contains("; 1 row left out; 1 warning: ", await ConvertAsync(_folder["cut.calc"], _folder[output]), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Only_a_file_that_says_no_rate_is_doubted_for_it()
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

    [Fact]
    public async Task An_export_of_bone_ends_becomes_no_body_and_keeps_its_rows()
    {
        _folder.Write("ends.calc", BoneEnds.Write(60));
        ToolResult refused = await ToolRunner.RunAsync("convert", _folder["ends.calc"], _folder["ends.bvh"]);
        Assert.Equal(1, refused.ExitCode);
        Assert.Contains("the ends of the bones instead of their centres", Assert.Single(refused.Error), StringComparison.Ordinal);
        Assert.Equal(1, (await ToolRunner.RunAsync("plot", _folder["ends.calc"], _folder["ends.svg"])).ExitCode);
        Assert.Equal(["ends.calc"], _folder.Names);

        await ConvertAsync(_folder["ends.calc"], _folder["ends.nmrec"]);
        await ConvertAsync(_folder["ends.nmrec"], _folder["back.calc"]);
        AssertSame(CalculationDocument.Load(_folder["ends.calc"]), CalculationDocument.Load(_folder["back.calc"]));

        ToolResult info = await ToolRunner.RunAsync("info", _folder["ends.calc"]);
        Assert.Equal(0, info.ExitCode);
        Assert.Contains(info.Output, static line => line.Contains("the ends of the bones instead of their centres", StringComparison.Ordinal));
        Assert.Contains(info.Output, static line => line.Contains("0.1736 0.9848 0 in the file's axes", StringComparison.Ordinal));
        Assert.DoesNotContain(info.Output, static line => line.Contains("upper leg", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Wrong_names_and_options_are_wrong_usage()
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
    [InlineData("--resample", "60")]
    [InlineData("--order", "XYZ")]
    [InlineData("--avatar", "0")]
    public async Task Bytes_are_copied_and_not_changed(string option, string value)
    {
        Takes.Actor(2).Save(_folder["a.bvh"]);
        await ConvertAsync(_folder["a.bvh"], _folder["a.nmrec"]);
        ToolResult result = await ToolRunner.RunAsync("convert", _folder["a.nmrec"], _folder["b.nmrec"], option, value);

        Assert.Equal(1, result.ExitCode);
        Assert.Contains(option, Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Equal(["a.bvh", "a.nmrec"], _folder.Names);
    }

    [Theory]
    [InlineData("")]
    [InlineData("nothing that anybody knows")]
    public async Task What_cannot_be_read_ends_with_1_and_leaves_nothing(string content)
    {
        _folder.Write("a.bvh", content);
        ToolResult result = await ToolRunner.RunAsync("convert", _folder["a.bvh"], _folder["b.nmrec"]);

        Assert.Equal(1, result.ExitCode);
        Assert.Contains("a.bvh", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Equal(["a.bvh"], _folder.Names);
    }

    [Fact]
    public async Task A_part_behind_the_end_is_told_and_leaves_nothing()
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

    [Fact]
    public async Task A_file_may_be_replaced_by_a_part_of_itself()
    {
        Takes.Actor(60).Save(_folder["a.bvh"]);
        Assert.Equal(1, (await ToolRunner.RunAsync("convert", _folder["a.bvh"], _folder["a.bvh"], "--from", "0.5")).ExitCode);
        await ConvertAsync(_folder["a.bvh"], _folder["a.bvh"], "--from", "0.5", "--overwrite");
        Assert.Equal(30, BvhDocument.Load(_folder["a.bvh"]).FrameCount);
    }

    public void Dispose() => _folder.Dispose();

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    // The line that says what the new file holds.
    private static async Task<string> ConvertAsync(string input, string output, params string[] options)
    {
        ToolResult result = await ToolRunner.RunAsync(["convert", input, output, .. options]);
        Assert.True(result.ExitCode == 0, string.Join('\n', result.Error));
        Assert.Empty(result.Output);
        string summary = Assert.Single(result.Error);
        Assert.StartsWith($"neuron-mocap: {Path.GetFileName(output)}: ", summary, StringComparison.Ordinal);
        return summary;
    }

    private static float[] Row(BvhDocument document, int frame) => document.GetFrame(frame).ToArray();

    private static float[] Values(BvhDocument document) => [.. Enumerable.Range(0, document.FrameCount).SelectMany(frame => Row(document, frame))];

    private static int[] Bits(IEnumerable<float> values) => [.. values.Select(BitConverter.SingleToInt32Bits)];

    private static void AssertSame(BvhDocument expected, BvhDocument actual)
    {
        Assert.Equal(
            expected.Joints.Select(static joint => (joint.Name, joint.Parent?.Name, joint.Offset, joint.EndSite)),
            actual.Joints.Select(static joint => (joint.Name, joint.Parent?.Name, joint.Offset, joint.EndSite)));
        Assert.Equal(expected.Joints.SelectMany(static joint => joint.Channels), actual.Joints.SelectMany(static joint => joint.Channels));
        Assert.Equal(expected.FrameTime, actual.FrameTime);
        Assert.Equal(Bits(Values(expected)), Bits(Values(actual)));
    }

    private static void AssertSame(CalculationDocument expected, CalculationDocument actual)
    {
        Assert.Equal(expected.FrameCount, actual.FrameCount);
        for (int row = 0; row < expected.FrameCount; row++)
            Assert.Equal(Bits(expected.GetValues(row).ToArray()), Bits(actual.GetValues(row).ToArray()));
    }

    private static List<TimeSpan> Times(string path) => [.. Frames(path).Select(static frame => frame.Time)];

    private static List<(TimeSpan Time, uint? Index, int[] Values)> Frames(string path)
    {
        var frames = new List<(TimeSpan, uint?, int[])>();
        using RecordedFrameReader reader = RecordedFrameReader.Open(path);
        while (reader.Read())
        {
            float[] values = reader.Frame is MotionFrame motion ? motion.Values.ToArray() : ((CalculationFrame)reader.Frame).Values.ToArray();
            frames.Add((reader.Time, reader.Frame.FrameIndex, Bits(values)));
        }

        return frames;
    }

    private static void AssertSameFrames(string expected, string actual)
    {
        List<(TimeSpan Time, uint? Index, int[] Values)> first = Frames(expected);
        List<(TimeSpan Time, uint? Index, int[] Values)> second = Frames(actual);
        Assert.Equal(first.Select(static frame => (frame.Time, frame.Index)), second.Select(static frame => (frame.Time, frame.Index)));
        Assert.Equal(first.SelectMany(static frame => frame.Values), second.SelectMany(static frame => frame.Values));
    }

    private sealed class Near(double tolerance) : IEqualityComparer<double>
    {
        public bool Equals(double x, double y) => Math.Abs(x - y) <= tolerance;

        public int GetHashCode(double obj) => 0;
    }

    private static Vector3[][] Joints(BvhDocument document)
    {
        Assert.True(BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out _));
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        return
        [
            .. Enumerable.Range(0, document.FrameCount).Select(frame =>
            {
                map.CopyLocalTransforms(frame, pose);
                ForwardKinematics.ToWorld(pose, pose, map.Format.Variant);
                return pose.Select(static bone => bone.Position).ToArray();
            }),
        ];
    }

    private static void AssertSamePoses(BvhDocument expected, BvhDocument actual, Func<int, int> frameOf)
    {
        Assert.True(BvhSkeletonMap.TryCreate(expected, out BvhSkeletonMap? expectedMap, out _));
        Assert.True(BvhSkeletonMap.TryCreate(actual, out BvhSkeletonMap? actualMap, out _));
        BoneTransform[] from = new BoneTransform[BoneHierarchy.BoneCount];
        BoneTransform[] to = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < actual.FrameCount; frame++)
        {
            expectedMap.CopyLocalTransforms(frameOf(frame), from);
            actualMap.CopyLocalTransforms(frame, to);
            for (int bone = 0; bone < from.Length; bone++)
            {
                Assert.Equal(from[bone].Position, to[bone].Position);
                Assert.InRange(MathF.Abs(Quaternion.Dot(from[bone].Rotation, to[bone].Rotation)), 0.999999f, 1.000001f);
            }
        }
    }
}
