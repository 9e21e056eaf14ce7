using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Playback;

public sealed class RawDumpTests
{
    [Fact]
    public void Frames_of_one_instant_share_a_time()
    {
        using var file = new TemporaryFile(
            [.. Enumerable.Range(0, 4).SelectMany(static frame => TestPackets.Join(TestPackets.Motion(frame), TestPackets.Motion(frame, avatar: 1), TestPackets.Calculation(frame)))]);
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path, new PlaybackOptions { FrameRate = 50 });
        double[] times = [.. RecordedFrames.ReadAll(reader).Select(static read => read.Time.TotalMilliseconds)];
        Assert.Equal([0, 0, 0, 20, 20, 20, 40, 40, 40, 60, 60, 60], times);
        Assert.Equal(Recordings.At(80), reader.Duration);
    }

    [Fact]
    public void The_rate_defaults_to_120_Hz()
    {
        using var file = new TemporaryFile(TestPackets.Motions(0, 121));
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        Assert.Equal(1.0, RecordedFrames.ReadAll(reader)[^1].Time.TotalSeconds, 6);
    }

    [Theory]
    [InlineData(24)]
    [InlineData(50)]
    [InlineData(60)]
    public void Timecodes_give_the_rate(int rate)
    {
        using var file = new TemporaryFile(TestPackets.Join(Enumerable.Range(rate / 3, 4 * rate).Select(frame => Studio(frame, rate))));
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        Assert.Equal(4.0, reader.Duration.TotalSeconds, 6);
    }

    [Fact]
    public void A_source_gives_whole_packets_and_can_seek()
    {
        byte[] bytes = [1, 2, 3, .. TestPackets.Motion(0), .. TestPackets.Motion(1), 4, 5, .. TestPackets.Motion(2), 6];
        using var file = new TemporaryFile(bytes);
        using RecordedEventSource source = RecordedEventSource.Open(file.Path, new PlaybackOptions { FrameRate = 100 });
        int packet = TestPackets.Motion(0).Length;

        Assert.Equal(["Opened 0 0", $"Bytes 0 {packet + 3}", $"Bytes 10 {packet}", $"Bytes 20 {packet + 2}", "Bytes 20 1", "End 30 0"], ReadAll(source));
        Assert.False(source.Seek(Recordings.At(19.9)));
        Assert.Equal($"Bytes 10 {packet}", ReadAll(source)[0]);
        Assert.False(source.Seek(Recordings.At(1000)));
        Assert.Equal(["End 30 0"], ReadAll(source));
        Assert.True(source.Seek(TimeSpan.Zero));
        Assert.Equal("Opened 0 0", ReadAll(source)[0]);
    }

    [Fact]
    public void A_copy_cannot_start_before_the_dump()
    {
        using var file = new TemporaryFile(TestPackets.Motions(0, 3));
        using var writer = new RecordingWriter(new MemoryStream());
        Assert.Throws<ArgumentOutOfRangeException>("from", () => RawDump.CopyTo(file.Path, writer, from: TimeSpan.MinValue));
        Assert.Throws<ArgumentOutOfRangeException>("from", () => RawDump.CopyTo(file.Path, writer, from: TimeSpan.FromTicks(-1)));

        RawDump.CopyTo(file.Path, writer);
        Assert.Equal(3, writer.Totals.Pieces);
    }

    private static List<string> ReadAll(RecordedEventSource source)
    {
        List<string> lines = [];
        RecordedEvent arrival;
        do
        {
            arrival = source.Read();
            lines.Add($"{arrival.Kind} {arrival.Time.TotalMilliseconds} {arrival.Bytes.Count}");
        }
        while (arrival.Kind != RecordedEventKind.End);

        return lines;
    }

    // From a second before midnight on, so that the clock restarts.
    private static byte[] Studio(int frame, int rate)
    {
        int second = (86_399 + (frame / rate)) % 86_400;
        byte[] packet = new byte[64 + (4 * 354)];
        PacketEncoder.WriteMotion(
            packet,
            new MotionHeader
            {
                Version = DataVersion.Studio,
                HasDisplacement = true,
                FrameIndex = (uint)frame,
                Reserved1 = (uint)((second / 3600 << 16) | (second / 60 % 60 << 8) | (second % 60)),
                Reserved2 = (uint)(frame % rate),
            },
            new float[354]);
        return packet;
    }
}
