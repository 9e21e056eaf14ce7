using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Playback;

// Steps and seeks: places of the recording other than the next.
public sealed class PlaybackPlaceTests
{
    [Fact]
    public async Task Steps_advance_a_paused_playback_frame_by_frame()
    {
        using TemporaryFile file = Recordings.OfTcp(
            (0, TestPackets.Motion(0)), (10, TestPackets.Motions(1, 3)), (20, [9, 9, .. TestPackets.Motion(4)[..99]]), (30, TestPackets.Motion(4)[99..]));
        using RecordingPlayer player = Played.Open(file, new FakeTime());
        player.Pause();
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        reader.Start();
        for (int count = 1; count <= 5; count++)
        {
            player.Step();
            await frames.WaitAsync(count);
            Assert.Equal(count, frames.Lines.Length);
        }

        Assert.Equal([0u, 1u, 2u, 3u, 4u], frames.Indices);
        Assert.Equal(30, player.Position.TotalMilliseconds);
        Assert.Equal((2, ConnectionState.Receiving), (reader.GetStatistics().BytesSkipped, reader.Status.State));
        // At the end, steps do nothing. While paused, it does not count as the end.
        for (int i = 0; i < 3; i++)
            player.Step();

        player.StepBack();
        await frames.WaitAsync(6);
        Assert.Equal(3u, frames.Indices[^1]);
        Assert.False(reader.Completion.IsCompleted);
        player.Resume();
        await reader.Completion.Soon();
        Assert.Equal([0u, 1u, 2u, 3u, 4u, 3u, 4u], frames.Indices);
    }

    [Fact]
    public async Task Steps_skip_a_datagram_without_a_frame()
    {
        using TemporaryFile file = Recordings.Write(static writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Udp, string.Empty, string.Empty));
            writer.AddSender(TimeSpan.Zero, 0, 0, "10.0.0.1:5000");
            writer.WriteBytes(Recordings.At(1), 0, TestPackets.Motion(0));
            writer.WriteBytes(Recordings.At(2), 0, new byte[100]);
            writer.WriteBytes(Recordings.At(3), 0, TestPackets.Motion(1));
        });
        using RecordingPlayer player = Played.Open(file, new FakeTime());
        player.Pause();
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        reader.Start();
        player.Step();
        await frames.WaitAsync(1);
        player.Step();
        await frames.WaitAsync(2);
        Assert.Equal([0u, 1u], frames.Indices);
        Assert.Equal(100, reader.GetStatistics().BytesSkipped);
    }

    [Fact]
    public async Task Steps_back_show_earlier_frames()
    {
        using TemporaryFile file = Played.Frames(400, interval: 8, perPiece: 3);
        using RecordingPlayer player = Played.Open(file, new FakeTime());
        player.Pause();
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        reader.Start();
        player.Seek(Recordings.At(8 * 100));
        player.Step();
        await frames.WaitAsync(1);
        Assert.Equal(300u, frames.Indices[0]);
        List<uint?> expected = [300u];
        for (int i = 0; i < 7; i++)
        {
            player.StepBack();
            expected.Add(299u - (uint)i);
            await frames.WaitAsync(expected.Count);
        }

        player.Step();
        expected.Add(294u);
        await frames.WaitAsync(expected.Count);
        Assert.Equal(expected, frames.Indices);
        Assert.Equal((0, 0), (reader.GetStatistics().BytesSkipped, reader.GetStatistics().Lost));

        // Further than the first look reaches, and to the start, where it stays.
        frames.Clear();
        player.Seek(player.Duration);
        for (int i = 0; i < 398; i++)
            player.StepBack();

        await Limits.UntilAsync(() => frames.Indices.LastOrDefault() == 1u);
        frames.Clear();
        player.StepBack();
        await frames.WaitAsync(1);
        player.StepBack();
        await frames.WaitAsync(2);
        Assert.Equal([0u, 0u], frames.Indices);
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(1, 1)]
    [InlineData(2999.9, 300)]
    [InlineData(3000, 300)]
    [InlineData(-5, 0)]
    [InlineData(3999, 400)]
    public async Task A_seek_continues_with_the_next_whole_frame(double milliseconds, int expected)
    {
        // Each packet is cut in two: the cut is before the place, the end after it.
        byte[] bytes = TestPackets.Motions(0, 401);
        int size = bytes.Length / 401;
        using TemporaryFile file = Recordings.OfTcp(
            [.. Enumerable.Range(0, 401).SelectMany(i => new[] { ((i * 10) - (i == 0 ? 0 : 1.0), bytes[(i * size)..((i * size) + 600)]), (i * 10.0, bytes[((i * size) + 600)..((i + 1) * size)]) })]);
        using RecordingPlayer player = Played.Open(file, new FakeTime());
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        player.Seek(Recordings.At(milliseconds));
        Assert.Equal(Math.Clamp(milliseconds, 0, 4000), player.Position.TotalMilliseconds);
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal(Enumerable.Range(expected, 401 - expected).Select(static index => (uint?)index), frames.Indices);
        Assert.Equal((0, 0), (reader.GetStatistics().BytesSkipped, reader.GetStatistics().Lost));
    }

    [Fact]
    public async Task A_seek_while_playing_loses_nothing()
    {
        using TemporaryFile file = Played.Frames(300, interval: 10);
        using RecordingPlayer player = Played.Open(file, new FakeTime());
        await using var reader = new NeuronReader(player);
        var statuses = new StatusLog(reader);
        bool hasSought = false;
        reader.MotionReceived += frame =>
        {
            if (frame.FrameIndex == 250 && !hasSought)
            {
                hasSought = true;
                player.Seek(Recordings.At(2000));
            }
        };
        using var frames = new FrameLog(reader);
        reader.Start();
        await reader.Completion.Soon();

        Assert.Equal([.. Enumerable.Range(0, 251), .. Enumerable.Range(200, 100)], frames.Indices.Select(static index => (int)index!));
        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal((0, 0, 0, 1), (statistics.Lost, statistics.Restarts, statistics.BytesSkipped, statistics.Reconnects));
        Assert.Equal(
            [ConnectionState.Connecting, ConnectionState.Connected, ConnectionState.Receiving, ConnectionState.Stopped],
            statuses.All.Select(static status => status.State));
        double[] milliseconds = frames.Milliseconds;
        Assert.Equal(milliseconds.Order(), milliseconds);
    }
}
