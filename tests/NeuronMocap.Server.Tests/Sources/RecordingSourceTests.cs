using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Bvh;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Playback;
using PlaybackOptions = NeuronMocap.Recording.PlaybackOptions;

namespace NeuronMocap.Server.Tests.Sources;

public sealed class RecordingSourceTests
{
    private static readonly ChannelLayout Displaced = new(hasDisplacement: true, hasReference: false);

    [Fact]
    public void Frames_keep_their_values_at_the_rate_of_their_times()
    {
        // A few milliseconds early or late, as in a real stream.
        using TemporaryFile file = Record(Enumerable.Range(0, 200), static frame => (frame / 60.0 * 1000) + (frame % 7));
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.Equal((0, "Char00", 200L, 0L), (source.AvatarIndex, source.AvatarName, source.FrameCount, source.InterpolatedFrames));
        Assert.Equal(60, source.FrameRate);
        Assert.InRange(source.MeasuredFrameRate!.Value, 59.8, 60.2);
        Assert.Empty(source.Gaps);
        float[] values = new float[354];
        for (int frame = 0; frame < 200; frame++)
        {
            source.WriteValues(frame, Displaced, RotationOrder.YXZ, values);
            BvhSamples.AssertBits(Values(frame), values);
        }
    }

    [Fact]
    public void Lost_frames_are_interpolated_to_keep_time()
    {
        using TemporaryFile file = Record(Enumerable.Range(0, 120).Where(static frame => frame is < 50 or > 52), static frame => frame / 60.0 * 1000);
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.Equal((120L, 117L, 3L), (source.FrameCount, source.ReceivedFrames, source.InterpolatedFrames));
        RecordedGap gap = Assert.Single(source.Gaps);
        Assert.Equal((53L, 3L, true), (gap.Frame, gap.Missing, gap.IsFilled));
        BoneTransform[] before = Pose(source, 49);
        BoneTransform[] filled = Pose(source, 51);
        BoneTransform[] after = Pose(source, 53);
        for (int bone = 0; bone < filled.Length; bone++)
        {
            Assert.InRange(Vector3.Distance((before[bone].Position + after[bone].Position) / 2, filled[bone].Position), 0, 1e-4f);
            Quaternion middle = Quaternion.Slerp(before[bone].Rotation, after[bone].Rotation, 0.5f);
            Assert.InRange(MathF.Abs(Quaternion.Dot(middle, filled[bone].Rotation)), 0.99999f, 1.00001f);
        }
    }

    [Fact]
    public void A_long_gap_is_skipped()
    {
        using TemporaryFile file = Record(Enumerable.Range(0, 200).Where(static frame => frame is < 50 or > 150), static frame => frame / 60.0 * 1000);
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.Equal((99L, 0L), (source.FrameCount, source.InterpolatedFrames));
        RecordedGap gap = Assert.Single(source.Gaps);
        Assert.Equal((50L, 101L, false), (gap.Frame, gap.Missing, gap.IsFilled));
        Assert.Equal(60, source.FrameRate);
    }

    // With filled gaps, it would be two billion frames.
    [Fact]
    public void An_index_jump_without_a_pause_is_no_gap()
    {
        using TemporaryFile file = Record([0, 1, 2, 2_000_000_000], static frame => Math.Min(frame, 3));
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.Equal((4L, 0L), (source.FrameCount, source.InterpolatedFrames));
        Assert.False(Assert.Single(source.Gaps).IsFilled);
    }

    [Fact]
    public void Every_second_index_is_half_the_rate_without_gaps()
    {
        using TemporaryFile file = Record(Enumerable.Range(0, 60).Select(static frame => frame * 2), static frame => frame / 120.0 * 1000);
        RecordingSource source = RecordingSource.Load(file.Path);
        Assert.Equal((60L, 60.0, 0), (source.FrameCount, source.FrameRate, source.Gaps.Count));
    }

    [Fact]
    public void Repeated_and_late_datagrams_are_sorted_and_kept_once()
    {
        int[] frames = [0, 1, 3, 2, 4, 4, 6, 7, 5, 8, 9];
        using TemporaryFile file = Recordings.Write(writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Udp, "0.0.0.0:7002", ""));
            writer.AddSender(TimeSpan.Zero, 0, 0, "10.0.0.1:7001");
            for (int i = 0; i < frames.Length; i++)
                writer.WriteBytes(Recordings.At(i * 10), 0, Packet(frames[i]));
        });
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.Equal((10L, 0L), (source.FrameCount, source.InterpolatedFrames));
        for (int frame = 0; frame < 10; frame++)
            BvhSamples.AssertBits(Values(frame), source.GetValues(frame));
    }

    [Fact]
    public void A_restarted_index_continues_at_once()
    {
        using TemporaryFile file = Recordings.OfTcp(
            [.. Enumerable.Range(1000, 30).Select(static frame => ((frame - 1000) * 10.0, Packet(frame))), .. Enumerable.Range(0, 30).Select(static frame => (400 + (frame * 10.0), Packet(frame)))]);
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.Equal(60, source.FrameCount);
        Assert.Equal((30L, null, false), (source.Gaps[0].Frame, source.Gaps[0].Missing, source.Gaps[0].IsFilled));
        Assert.Equal(100, source.FrameRate);
    }

    [Fact]
    public void Contacts_come_from_calculation_frames()
    {
        using TemporaryFile file = Recordings.OfTcp([.. Enumerable.Range(0, 20).SelectMany(static frame => ((double, byte[])[])
        [
            (frame * 10, Packet(frame)),
            (frame * 10, Contacts(frame, left: frame % 2 == 0, right: frame % 3 == 0)),
        ])]);
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.True(source.HasMeasuredContacts);
        for (int frame = 0; frame < 20; frame++)
            Assert.Equal(new FootContacts(frame % 2 == 0, frame % 3 == 0), source.GetFootContacts(frame));
    }

    [Fact]
    public void Each_avatar_can_be_chosen_and_an_unknown_one_lists_them()
    {
        using TemporaryFile file = Recordings.OfTcp(
            [.. Enumerable.Range(0, 10).SelectMany(static frame => ((double, byte[])[])[(frame * 10, Packet(frame)), (frame * 10, Packet(frame, avatar: 2))])]);

        Assert.Equal(0, RecordingSource.Load(file.Path).AvatarIndex);
        RecordingSource second = RecordingSource.Load(file.Path, avatarIndex: 2);
        Assert.Equal((2, 10L), (second.AvatarIndex, second.FrameCount));
        NeuronException exception = Assert.Throws<NeuronException>(() => RecordingSource.Load(file.Path, avatarIndex: 1));
        Assert.Contains("there are 0 (Char00), 2 (Char00)", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_changed_layout_is_converted_to_the_first()
    {
        using TemporaryFile file = Recordings.OfTcp((0, Packet(0)), (10, TestPackets.Motion(1, count: 180)), (20, Packet(2)));
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.Equal((3L, 354), (source.FrameCount, source.Layout.ValueCount));
        BoneTransform[] pose = Pose(source, 1);
        Assert.Equal(DefaultOffsets.Get(Bone.LeftForeArm), pose[(int)Bone.LeftForeArm].Position);
        Assert.Equal(TestPackets.Value(1, 0, 0), pose[0].Position.X);
    }

    [Fact]
    public void The_body_comes_from_the_metadata()
    {
        Vector3[] offsets = [.. BoneHierarchy.Bones.ToArray().Select(static bone => DefaultOffsets.Get(bone) * 1.25f)];
        string hierarchy = BvhHierarchyText.Create(offsets, new Vector3[BoneHierarchy.BoneCount], SkeletonFormat.Default, new ChannelLayout(false, false));
        using TemporaryFile file = Recordings.Write(
            static writer =>
            {
                writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "", ""));
                writer.WriteBytes(TimeSpan.Zero, 0, TestPackets.Motion(0, count: 180));
            },
            RecordingMetadata.Empty.With(RecordingMetadata.BvhHierarchyKey, hierarchy));
        RecordingSource source = RecordingSource.Load(file.Path);

        Assert.True(source.HasOwnBody);
        Assert.Equal(offsets[(int)Bone.LeftForeArm].X, Pose(source, 0)[(int)Bone.LeftForeArm].Position.X, 1e-4f);
        using TemporaryFile without = Recordings.OfTcp((0, TestPackets.Motion(0, count: 180)));
        Assert.False(RecordingSource.Load(without.Path).HasOwnBody);
    }

    [Fact]
    public void The_body_falls_back_to_the_command_channels_sizes()
    {
        BoneDimensions sizes = SkeletonBody.GetDefault().Measure() with { UpperArm = 0.35f, UpperLeg = 0.5f };
        RecordingMetadata metadata = RecordingMetadata.Empty.With(RecordingMetadata.BoneDimensionsKey, RecordingMetadata.ToText(sizes));
        using TemporaryFile file = RecordOne(TestPackets.Motion(0, count: 180), metadata);
        RecordingSource source = RecordingSource.Load(file.Path);
        Vector3[] offsets = new Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, new Vector3[BoneHierarchy.BoneCount]);

        Assert.True(source.HasOwnBody);
        Assert.Equal(35, offsets[(int)Bone.LeftForeArm].Length(), 1e-3f);
        Assert.Equal(50, Pose(source, 0)[(int)Bone.RightLeg].Position.Length(), 1e-3f);

        // Displacement carries more than twelve sizes.
        using TemporaryFile displaced = RecordOne(Packet(0), metadata);
        Assert.Equal(Values(0)[(int)Bone.LeftForeArm * 6], Pose(RecordingSource.Load(displaced.Path), 0)[(int)Bone.LeftForeArm].Position.X);
    }

    [Theory]
    [InlineData(null, 120)]
    [InlineData(59.94, 59.94)]
    public void A_dump_uses_the_given_rate_despite_losses(double? given, double rate)
    {
        using var file = new TemporaryFile([.. Enumerable.Range(0, 40).Where(static frame => frame is < 20 or > 24).SelectMany(static frame => Packet(frame))]);
        RecordingSource source = RecordingSource.Load(file.Path, options: new PlaybackOptions { FrameRate = given });

        Assert.Equal((rate, null, 40L, 5L), (source.FrameRate, source.MeasuredFrameRate, source.FrameCount, source.InterpolatedFrames));
    }

    [Fact]
    public void A_recording_without_poses_is_refused()
    {
        using TemporaryFile file = Recordings.OfTcp((0, Contacts(0, left: true, right: true)));
        Assert.Contains("no motion frame", Assert.Throws<NeuronException>(() => RecordingSource.Load(file.Path)).Message, StringComparison.Ordinal);
    }

    private static TemporaryFile Record(IEnumerable<int> frames, Func<int, double> milliseconds) =>
        Recordings.OfTcp([.. frames.Select(frame => (milliseconds(frame), Packet(frame)))]);

    // Bones that move and turn a little from frame to frame.
    private static float[] Values(int frame) => [.. Enumerable.Range(0, 354).Select(index => (frame / 8f) + (index / 1024f))];

    private static TemporaryFile RecordOne(byte[] packet, RecordingMetadata metadata) => Recordings.Write(
        writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "", ""));
            writer.WriteBytes(TimeSpan.Zero, 0, packet);
        },
        metadata);

    private static byte[] Packet(int frame) => Packet(frame, avatar: 0);

    private static byte[] Packet(int frame, int avatar)
    {
        byte[] packet = new byte[64 + (354 * 4)];
        var header = new MotionHeader
        {
            HasDisplacement = true,
            AvatarIndex = avatar,
            AvatarName = new AvatarName("Char00"),
            FrameIndex = (uint)frame,
        };
        PacketEncoder.WriteMotion(packet, header, Values(frame));
        return packet;
    }

    private static byte[] Contacts(int frame, bool left, bool right)
    {
        float[] values = new float[946];
        (values[336], values[337]) = (left ? 1 : 0, right ? 1 : 0);
        byte[] packet = new byte[64 + (946 * 4)];
        PacketEncoder.WriteCalculation(packet, new CalculationHeader { AvatarName = new AvatarName("Char00"), FrameIndex = (uint)frame }, values);
        return packet;
    }

    private static BoneTransform[] Pose(RecordingSource source, long frame)
    {
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        source.GetPose(frame, pose);
        return pose;
    }
}
