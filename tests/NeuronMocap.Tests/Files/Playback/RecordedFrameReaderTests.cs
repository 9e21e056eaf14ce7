using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Reader;

namespace NeuronMocap.Tests.Playback;

public sealed class RecordedFrameReaderTests
{
    private static readonly RecordedConnection Tcp = new(0, TransportKind.Tcp, string.Empty, "10.0.0.1:7001");

    [Fact]
    public void Frames_of_a_recording_come_with_their_times()
    {
        byte[] second = TestPackets.Motion(1);
        using TemporaryFile file = Recordings.OfTcp(
            (5, TestPackets.Motion(0)), (20, second[..100]), (30, [.. second[100..], .. TestPackets.Calculation(7), .. TestPackets.Studio(8)]));
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        Assert.Equal(Recordings.At(30), reader.Duration);

        (string, uint?, double)[] found = [.. RecordedFrames.ReadAll(reader).Select(static read => (read.Frame.GetType().Name, read.Frame.FrameIndex, read.Time.TotalMilliseconds))];

        Assert.Equal(
            [(nameof(MotionFrame), 0u, 5), (nameof(MotionFrame), 1u, 30), (nameof(CalculationFrame), 7u, 30), (nameof(StudioCalculationFrame), 8u, 30)],
            found);
        Assert.Throws<InvalidOperationException>(() => reader.Frame);
        Assert.False(reader.Read());
        Assert.Equal((2, 1, 1), ((int)reader.GetStatistics().MotionFrames, (int)reader.GetStatistics().CalculationFrames, (int)reader.GetStatistics().StudioCalculationFrames));
    }

    [Fact]
    public void Skipped_bytes_are_counted_by_reason()
    {
        using TemporaryFile file = Recordings.OfTcp((0, [1, 2, 3, .. TestPackets.Motion(0)]), (1, TestPackets.Motion(1)[..200]));
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        Assert.Single(RecordedFrames.ReadAll(reader));
        Assert.Equal((3, 200), (reader.GetSkipped(SkipReason.NoTokens), reader.GetSkipped(SkipReason.Incomplete)));
        Assert.Equal(203 + TestPackets.Motion(0).Length, reader.GetStatistics().BytesReceived);
    }

    [Fact]
    public void Packets_do_not_continue_across_connections()
    {
        byte[] packet = TestPackets.Motion(9);
        using TemporaryFile file = Recordings.Write(writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, Tcp);
            writer.WriteBytes(TimeSpan.Zero, 0, packet.AsSpan(0, 300));
            writer.CloseConnection(Recordings.At(10), 0, string.Empty);
            writer.OpenConnection(Recordings.At(20), Tcp with { Number = 1 });
            writer.WriteBytes(Recordings.At(21), 1, packet.AsSpan(300));
            writer.WriteBytes(Recordings.At(22), 1, packet);
        });
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        Assert.True(reader.Read());
        Assert.Equal((1, 22.0, 9u), (reader.Connection, reader.Time.TotalMilliseconds, reader.Frame.FrameIndex));
        Assert.False(reader.Read());
        Assert.Equal((300, 1), (reader.GetSkipped(SkipReason.Incomplete), reader.GetStatistics().Reconnects));
    }

    [Fact]
    public void Packets_are_not_joined_across_lost_bytes()
    {
        byte[] packet = TestPackets.Motion(0);
        using TemporaryFile file = Recordings.Write(writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, Tcp);
            writer.WriteBytes(Recordings.At(1), 0, packet.AsSpan(0, 300));
            writer.WriteLoss(Recordings.At(2), 0, pieces: 1, bytes: packet.Length);
            writer.WriteBytes(Recordings.At(3), 0, packet.AsSpan(300));
            writer.WriteBytes(Recordings.At(4), 0, TestPackets.Motion(3));
        });
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        Assert.Equal([3u], RecordedFrames.ReadAll(reader).Select(static read => read.Frame.FrameIndex));
    }

    // Bytes of every connection may be missing, whichever connection the lost block held.
    [Fact]
    public void Packets_of_no_connection_are_joined_across_a_damaged_block()
    {
        byte[] packet = TestPackets.Calculation(0);
        long start = 0, end = 0;
        using TemporaryFile file = Recordings.Write(writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, Tcp);
            writer.OpenConnection(TimeSpan.Zero, Tcp with { Number = 1, IsCalculation = true });
            writer.WriteBytes(Recordings.At(1), 1, packet.AsSpan(0, 1000));
            writer.Flush();
            start = writer.WrittenLength;
            writer.WriteBytes(Recordings.At(2), 1, packet.AsSpan(1000));
            writer.Flush();
            end = writer.WrittenLength;
            writer.WriteBytes(Recordings.At(3), 1, TestPackets.Calculation(2));
        });
        byte[] bytes = File.ReadAllBytes(file.Path);
        bytes[(start + end) / 2] ^= 1;
        File.WriteAllBytes(file.Path, bytes);

        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        (AvatarFrame frame, _) = Assert.Single(RecordedFrames.ReadAll(reader));
        Assert.Equal(2u, frame.FrameIndex);
        Assert.Equal(Enumerable.Range(0, 946).Select(static i => TestPackets.Value(2, 0, i)), frame.Values.ToArray());
    }

    [Fact]
    public void Each_UDP_sender_has_its_own_frames()
    {
        (byte[] first, byte[] second) = (TestPackets.Motion(1), TestPackets.Motion(2));
        using TemporaryFile file = Recordings.Write(writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Udp, "0.0.0.0:7012", string.Empty));
            writer.AddSender(TimeSpan.Zero, 0, 0, "10.0.0.1:5000");
            writer.WriteBytes(Recordings.At(1), 0, first.AsSpan(0, 1024), sender: 0);
            writer.AddSender(TimeSpan.Zero, 0, 1, "10.0.0.2:5000");
            writer.WriteBytes(Recordings.At(2), 0, second.AsSpan(0, 1024), sender: 1);
            writer.WriteBytes(Recordings.At(3), 0, first.AsSpan(1024), sender: 0);
            writer.WriteBytes(Recordings.At(4), 0, second.AsSpan(1024), sender: 1);
        });
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        Assert.Equal([(1u, 0), (2u, 1)], RecordedFrames.ReadAll(reader).Select(static read => ((uint)read.Frame.FrameIndex!, read.Frame.Sender)));
        Assert.Equal(0, reader.GetStatistics().BytesSkipped);
    }

    [Theory]
    [InlineData(null, null, RotationOrder.YXZ, SkeletonVariant.Neck1)]
    [InlineData("ZXY", null, RotationOrder.ZXY, SkeletonVariant.Spine3)]
    [InlineData("ZXY", RotationOrder.XYZ, RotationOrder.XYZ, SkeletonVariant.Spine3)]
    public void The_format_comes_from_the_options_or_the_recording(
        string? recorded, RotationOrder? option, RotationOrder expected, SkeletonVariant variant)
    {
        RecordingMetadata metadata = recorded is null
            ? RecordingMetadata.Empty
            : new RecordingMetadata().With(RecordingMetadata.RotationOrderKey, recorded).With(RecordingMetadata.SkeletonVariantKey, "Spine3");
        using TemporaryFile file = Recordings.Write(
            writer =>
            {
                writer.OpenConnection(TimeSpan.Zero, Tcp);
                writer.WriteBytes(TimeSpan.Zero, 0, TestPackets.Motion(0));
            },
            metadata);
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path, new PlaybackOptions { RotationOrder = option });
        Assert.True(reader.Read());
        Assert.Equal(new SkeletonFormat(expected, variant), ((MotionFrame)reader.Frame).Format);
    }

    [Fact]
    public void The_packet_limit_comes_from_the_recording()
    {
        RecordingMetadata metadata = new RecordingMetadata().With(RecordingMetadata.MaxValuesKey, "300");
        using TemporaryFile file = Recordings.Write(
            writer =>
            {
                writer.OpenConnection(TimeSpan.Zero, Tcp);
                writer.WriteBytes(TimeSpan.Zero, 0, [.. TestPackets.Motion(0, count: 354), .. TestPackets.Motion(1, count: 180)]);
            },
            metadata);
        using (RecordedFrameReader reader = RecordedFrameReader.Open(file.Path))
        {
            Assert.Equal([1u], RecordedFrames.ReadAll(reader).Select(static read => read.Frame.FrameIndex));
            Assert.Equal(1, reader.GetStatistics().OversizedPackets);
        }

        using RecordedFrameReader wider = RecordedFrameReader.Open(file.Path, new PlaybackOptions { MaxValues = 354 });
        Assert.Equal(2, RecordedFrames.ReadAll(wider).Count);
    }

    [Theory]
    [MemberData(nameof(FixtureReaderTests.Names), MemberType = typeof(FixtureReaderTests))]
    public void Dumps_and_recordings_give_the_same_frames(string name)
    {
        StreamFixture fixture = StreamFixture.Load(name);
        using var dump = new TemporaryFile(fixture.Bytes, ".bin");
        using TemporaryFile recording = Recordings.OfTcp([.. Splits.Random(fixture.Bytes, new Random(7)).Select(static (piece, i) => ((double)i, piece.ToArray()))]);
        using RecordedFrameReader ofDump = RecordedFrameReader.Open(dump.Path);
        using RecordedFrameReader ofRecording = RecordedFrameReader.Open(recording.Path);
        string[] frames = [.. RecordedFrames.ReadAll(ofDump).Select(static read => Recordings.Describe(read.Frame))];

        Assert.Equal(fixture.Expected.Count, frames.Length);
        Assert.Equal(frames, RecordedFrames.ReadAll(ofRecording).Select(static read => Recordings.Describe(read.Frame)));
        Assert.Equal(fixture.Expected.Select(static expected => expected.Index), ofDumpIndices());
        Assert.Equal(fixture.Bytes.Length, ofDump.GetStatistics().BytesReceived);
        Assert.Equal(ofDump.GetStatistics().BytesSkipped, ofRecording.GetStatistics().BytesSkipped);

        IEnumerable<uint?> ofDumpIndices()
        {
            using RecordedFrameReader again = RecordedFrameReader.Open(dump.Path);
            return [.. RecordedFrames.ReadAll(again).Select(static read => read.Frame.FrameIndex)];
        }
    }

    [Theory]
    [InlineData("", "is empty")]
    [InlineData("HIERARCHY\nROOT Hips", "BVH")]
    [InlineData("nothing to see", "neither a recording nor a dump")]
    public void Another_kind_of_file_is_named_and_refused(string content, string expected)
    {
        using var file = new TemporaryFile(System.Text.Encoding.ASCII.GetBytes(content), ".nmrec");
        PlaybackException exception = Assert.Throws<PlaybackException>(() => RecordedFrameReader.Open(file.Path));
        Assert.Contains(expected, exception.Message, StringComparison.Ordinal);
        Assert.Contains(file.Path, exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Only_dumps_accept_a_rate()
    {
        using TemporaryFile file = Recordings.OfTcp((0, TestPackets.Motion(0)));
        Assert.Throws<ArgumentException>(() => RecordedFrameReader.Open(file.Path, new PlaybackOptions { FrameRate = 60 }));
        Assert.Throws<ArgumentException>(() => RecordedFrameReader.Open(file.Path, new PlaybackOptions { FrameRate = 0 }));
    }
}
