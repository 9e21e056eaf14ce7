using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Playback;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhTakeWriterTests
{
    public static MatrixTheoryData<SkeletonVariant, RotationOrder, bool, bool> EveryFormat =>
        new(Enum.GetValues<SkeletonVariant>(), Enum.GetValues<RotationOrder>(), [false, true], [false, true]);

    [Theory, MemberData(nameof(EveryFormat))]
    public void Frames_of_every_format_are_written_bit_for_bit(SkeletonVariant variant, RotationOrder order, bool displacement, bool reference)
    {
        var format = new SkeletonFormat(order, variant);
        var layout = new ChannelLayout(displacement, reference);
        float[] values = [.. Enumerable.Range(0, layout.ValueCount).Select(static i => i + 0.1f)];
        BvhDocument take = Write(null, Frame(1, values, format), Frame(2, [.. values.Select(static value => -value)], format));

        Assert.Empty(take.Repairs);
        Assert.True(BvhSkeletonMap.TryCreate(take, out BvhSkeletonMap? map, out string? reason), reason);
        Assert.Equal(format, map.Format);
        Assert.Equal(layout, map.Layout);
        Assert.Equal(2, take.FrameCount);
        AssertBits(values, take.GetValues(0));
        AssertBits([.. values.Select(static value => -value)], take.GetValues(1));
    }

    [Fact]
    public void Offsets_come_from_a_stream_with_displacement()
    {
        var body = SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperLeg = 0.5f, FootLength = 0.3f });
        float[] values = Displaced(body);
        BvhDocument take = Write(new BvhTakeOptions { Body = SkeletonBody.GetDefault() }, Frame(1, values));

        Assert.Equal(-50, take.Joints[2].Offset.Y, 1e-3);
        Assert.Equal(SkeletonBody.GetDefault().EndSites[3], take.Joints[3].EndSite);
        Assert.Equal(0, take.Joints[0].Offset.X);
    }

    [Fact]
    public void Offsets_come_from_the_options_without_displacement()
    {
        var body = SkeletonBody.FromDimensions(SkeletonBody.GetDefault().Measure() with { UpperLeg = 0.5f });
        Assert.Equal(body.Offsets.ToArray(), Write(new BvhTakeOptions { Body = body }, Frame(1, new float[180])).Joints.Select(static joint => joint.Offset));
        Assert.Equal(
            SkeletonBody.GetDefault().Offsets.ToArray(),
            Write(new BvhTakeOptions { Body = SkeletonBody.GetDefault(SkeletonVariant.Spine3) }, Frame(1, new float[180])).Joints.Select(static joint => joint.Offset));
    }

    // NaN affects a row, but not the body.
    [Fact]
    public void A_first_frame_of_NaN_gets_the_default_body()
    {
        float[] values = new float[354];
        Array.Fill(values, float.NaN);
        BvhDocument take = Write(null, Frame(1, values));

        Assert.Equal(SkeletonBody.GetDefault().Offsets.ToArray(), take.Joints.Select(static joint => joint.Offset));
        AssertBits(values, take.GetValues(0));
    }

    [Fact]
    public void Frames_of_another_layout_are_not_accepted()
    {
        using var writer = new BvhTakeWriter(new MemoryStream());
        Assert.False(writer.Accepts(Frame(1, new float[7])));
        writer.Write(Frame(1, new float[180]));

        Assert.True(writer.Accepts(Frame(2, new float[180])));
        MotionFrame[] others =
        [
            Frame(2, new float[354]),
            Frame(2, new float[180], new SkeletonFormat(RotationOrder.XYZ, SkeletonVariant.Neck1)),
            Frame(2, new float[180], new SkeletonFormat(RotationOrder.YXZ, SkeletonVariant.Spine3)),
        ];
        foreach (MotionFrame other in others)
        {
            Assert.False(writer.Accepts(other));
            Assert.Throws<InvalidOperationException>(() => writer.Write(other));
        }
    }

    [Fact]
    public void The_frame_time_comes_from_the_options()
    {
        using var oneWay = new MemoryStream();
        BvhDocument take = Write(new BvhTakeOptions { FrameTime = new BvhFrameTime(1, 96) }, Frame(1, new float[180]));
        Assert.Equal(new BvhFrameTime(1, 96), take.FrameTime);
    }

    // Two frames in the middle are missing. The arrival times are even.
    [Theory]
    [InlineData(BvhGapHandling.Repeat, 12, 2)]
    [InlineData(BvhGapHandling.Skip, 10, 0)]
    public void Missing_frames_are_repeated_or_left_out(BvhGapHandling gaps, int rows, int repeated)
    {
        using TemporaryFile file = Recordings.OfTcp(
            [.. Enumerable.Range(0, 12).Where(static frame => frame is not (5 or 6)).Select(static frame => (frame * 12.5, TestPackets.Motion(frame, count: 180)))]);
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        var stream = new MemoryStream();
        using var writer = new BvhTakeWriter(stream, new BvhTakeOptions { GapHandling = gaps });
        while (reader.Read())
            writer.Write((MotionFrame)reader.Frame);

        Assert.Equal((rows, repeated, 80.0), (writer.FrameCount, writer.RepeatedFrames, writer.FrameTime.FrameRate));
    }

    [Fact]
    public void A_file_without_frames_is_empty()
    {
        var stream = new MemoryStream();
        var writer = new BvhTakeWriter(stream);
        writer.Flush();
        writer.Dispose();
        writer.Dispose();
        Assert.Empty(stream.ToArray());
    }

    [Fact]
    public void A_frame_allocates_nothing()
    {
        string path = Path.GetTempFileName();
        MotionFrame frame = Frame(1, [.. Enumerable.Range(0, 354).Select(static i => i / 7f)]);
        using (var writer = new BvhTakeWriter(path))
            Allocations.AssertNone(() => writer.Write(frame));

        File.Delete(path);
    }

    private static MotionFrame Frame(uint index, float[] values, SkeletonFormat? format = null) =>
        new(new MotionHeader { AvatarName = new AvatarName("Char00"), FrameIndex = index }, values, format);

    private static float[] Displaced(SkeletonBody body)
    {
        float[] values = new float[354];
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Vector3 offset = body.GetOffset(bone);
            (values[layout.GetPositionIndex(bone)], values[layout.GetPositionIndex(bone) + 1], values[layout.GetPositionIndex(bone) + 2]) = (offset.X, offset.Y, offset.Z);
        }

        values[0] = 123;
        return values;
    }

    private static BvhDocument Write(BvhTakeOptions? options, params MotionFrame[] frames)
    {
        var stream = new MemoryStream();
        using (var writer = new BvhTakeWriter(stream, options))
        {
            foreach (MotionFrame frame in frames)
                writer.Write(frame);
        }

        return BvhDocument.Parse(stream.ToArray());
    }
}
