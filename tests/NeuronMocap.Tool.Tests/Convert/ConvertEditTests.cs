using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using static NeuronMocap.Tool.Tests.Convert.Conversion;
using static NeuronMocap.Tool.Tests.Convert.TakeComparison;

namespace NeuronMocap.Tool.Tests.Convert;

public sealed class ConvertEditTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Fact]
    public async Task BVH_files_are_cut_resampled_and_reordered()
    {
        Takes.Actor(240, rate: 120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["part.bvh"], "--from", "0.5", "--to", "1.5", "--resample", "60", "--output-order", "ZYX");
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
    public async Task A_part_of_a_recording_keeps_bytes_and_times()
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

    [Theory]
    [InlineData("part.nmrec")]
    [InlineData("part.bvh")]
    [InlineData("part.bin")]
    public async Task A_part_of_a_recording_is_the_same_in_every_kind_of_file(string output)
    {
        // The stream begins after two seconds, and pauses for three.
        using (var recording = new GlbRecording(_folder["take.nmrec"]))
        {
            for (int frame = 0; frame < 240; frame++)
                recording.Add(2 + (frame / 60.0) + (frame < 120 ? 0 : 3), frame);
        }

        Assert.Contains(": 90 frames", await ConvertAsync(_folder["take.nmrec"], _folder[output], "--from", "3", "--to", "7.5"), StringComparison.Ordinal);
        await ConvertAsync(_folder["take.nmrec"], _folder["whole.bvh"]);
        await ConvertAsync(_folder[output], _folder["poses.bvh"], "--overwrite");
        AssertSamePoses(BvhDocument.Load(_folder["whole.bvh"]), BvhDocument.Load(_folder["poses.bvh"]), static frame => 60 + frame);
    }

    [Theory]
    [InlineData("part.bvh")]
    [InlineData("part.glb")]
    public async Task A_part_of_a_recording_without_poses_has_the_rows_that_arrived_in_it(string output)
    {
        Takes.Actor(240).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        await ConvertAsync(_folder["take.calc"], _folder["rows.nmrec"]);
        using (RecordingReader reader = RecordingReader.Open(_folder["rows.nmrec"]))
        using (RecordingWriter writer = RecordingWriter.Create(_folder["late.nmrec"], reader.Metadata))
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
            while (reader.TryRead(out RecordingEntry entry))
            {
                if (entry.Kind == RecordingEntryKind.Bytes)
                    writer.WriteBytes(entry.Time + TimeSpan.FromSeconds(2), 0, entry.Bytes);
            }
        }

        Assert.Contains(": 30 frames, 0.500 s at 60 Hz; ", await ConvertAsync(_folder["late.nmrec"], _folder[output], "--to", "2.5"), StringComparison.Ordinal);
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

    // From 24 to 60 Hz, only the first frame coincides with one of the take.
    [Fact]
    public async Task Resampled_frames_are_interpolated()
    {
        Takes.StraightWalk(frames: 24, rate: 24).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.nmrec"], _folder["more.bvh"], "--resample", "60");
        BvhDocument more = BvhDocument.Load(_folder["more.bvh"]);

        Assert.Equal(58, more.FrameCount);
        for (int frame = 0; frame < more.FrameCount; frame++)
            Assert.Equal(frame / 60f * 100, more.GetValues(frame)[2], 0.001f);
    }

    [Fact]
    public async Task The_order_option_applies_to_every_input()
    {
        Takes.Actor(60).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.nmrec"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.bin"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.calc"]);
        foreach (string input in (string[])["take.bvh", "take.nmrec", "take.bin"])
        {
            string output = _folder[input + ".bvh"];
            await ConvertAsync(_folder[input], output, "--output-order", "XYZ");
            Assert.True(BvhSkeletonMap.TryCreate(BvhDocument.Load(output), out BvhSkeletonMap? map, out _));
            Assert.Equal(RotationOrder.XYZ, map.Format.RotationOrder);
            AssertSamePoses(BvhDocument.Load(_folder["take.bvh"]), BvhDocument.Load(output), static frame => frame);
        }

        await ConvertAsync(_folder["take.calc"], _folder["yxz.bvh"]);
        await ConvertAsync(_folder["take.calc"], _folder["xyz.bvh"], "--output-order", "XYZ");
        AssertSamePoses(BvhDocument.Load(_folder["yxz.bvh"]), BvhDocument.Load(_folder["xyz.bvh"]), static frame => frame);

        await ConvertAsync(_folder["take.bvh"], _folder["zyx.nmrec"], "--output-order", "ZYX");
        await ConvertAsync(_folder["zyx.nmrec"], _folder["zyx.bvh"]);
        AssertSamePoses(BvhDocument.Load(_folder["take.bvh"]), BvhDocument.Load(_folder["zyx.bvh"]), static frame => frame);
    }

    [Fact]
    public async Task A_file_can_be_cut_in_place()
    {
        Takes.Actor(60).Save(_folder["a.bvh"]);
        Assert.Equal(1, (await ToolRunner.RunAsync("convert", _folder["a.bvh"], _folder["a.bvh"], "--from", "0.5")).ExitCode);
        await ConvertAsync(_folder["a.bvh"], _folder["a.bvh"], "--from", "0.5", "--overwrite");
        Assert.Equal(30, BvhDocument.Load(_folder["a.bvh"]).FrameCount);
    }

    public void Dispose() => _folder.Dispose();
}
