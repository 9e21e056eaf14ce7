using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Playback;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Playback;

public sealed class RecordingPlayerTests
{
    private static readonly RecordedConnection Tcp = new(0, TransportKind.Tcp, string.Empty, string.Empty);

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(0.5)]
    public async Task Frames_come_at_their_times(double speed)
    {
        using TemporaryFile file = TenFrames();
        var time = new FakeTime();
        using RecordingPlayer player = Open(file, time);
        player.Speed = speed;
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        reader.Start();
        await reader.Completion.Soon();

        double[] expected = [.. Enumerable.Range(0, 10).Select(frame => Math.Round(frame * 8.3 / speed, 3))];
        Assert.Equal(expected, frames.Milliseconds);
        Assert.Equal(expected[1..], time.Waits.Select(static wait => Math.Round(wait, 3)).Distinct());
        Assert.Equal((player.Duration, 1), (player.Position, player.Pass));
    }

    [Fact]
    public async Task A_new_speed_counts_from_the_frame_on_that_was_reached()
    {
        using TemporaryFile file = Frames(5, interval: 100);
        using RecordingPlayer player = Open(file, new FakeTime());
        await using var reader = new NeuronReader(player);
        reader.MotionReceived += frame => player.Speed = frame.FrameIndex == 2 ? 10 : player.Speed;
        using var frames = new FrameLog(reader);
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal([0, 100, 200, 210, 220], frames.Milliseconds);
    }

    [Fact]
    public async Task Paused_nothing_comes_and_steps_go_frame_by_frame_also_within_a_piece()
    {
        using TemporaryFile file = Recordings.OfTcp(
            (0, TestPackets.Motion(0)), (10, TestPackets.Motions(1, 3)), (20, [9, 9, .. TestPackets.Motion(4)[..99]]), (30, TestPackets.Motion(4)[99..]));
        using RecordingPlayer player = Open(file, new FakeTime());
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
        Assert.Equal((2, ConnectionState.Receiving), (reader.GetStatistics().SkippedBytes, reader.Status.State));
        // At the end steps do nothing, and it is no end as long as it is paused.
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
    public async Task Steps_pass_over_a_datagram_without_a_frame_once()
    {
        using TemporaryFile file = Recordings.Write(static writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Udp, string.Empty, string.Empty));
            writer.AddSender(TimeSpan.Zero, 0, 0, "10.0.0.1:5000");
            writer.WriteBytes(Recordings.At(1), 0, TestPackets.Motion(0));
            writer.WriteBytes(Recordings.At(2), 0, new byte[100]);
            writer.WriteBytes(Recordings.At(3), 0, TestPackets.Motion(1));
        });
        using RecordingPlayer player = Open(file, new FakeTime());
        player.Pause();
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        reader.Start();
        player.Step();
        await frames.WaitAsync(1);
        player.Step();
        await frames.WaitAsync(2);
        Assert.Equal([0u, 1u], frames.Indices);
        Assert.Equal(100, reader.GetStatistics().SkippedBytes);
    }

    [Fact]
    public async Task Steps_back_show_the_frames_before()
    {
        using TemporaryFile file = Frames(400, interval: 8, perPiece: 3);
        using RecordingPlayer player = Open(file, new FakeTime());
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
        Assert.Equal((0, 0), (reader.GetStatistics().SkippedBytes, reader.GetStatistics().Lost));

        // Further than what is looked at first, and to the start, where it stays.
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
    public async Task A_seek_goes_on_with_the_first_frame_that_was_whole_then_or_later(double milliseconds, int expected)
    {
        // Each packet is cut in two: the cut lies before the place, the end behind it.
        byte[] bytes = TestPackets.Motions(0, 401);
        int size = bytes.Length / 401;
        using TemporaryFile file = Recordings.OfTcp(
            [.. Enumerable.Range(0, 401).SelectMany(i => new[] { ((i * 10) - (i == 0 ? 0 : 1.0), bytes[(i * size)..((i * size) + 600)]), (i * 10.0, bytes[((i * size) + 600)..((i + 1) * size)]) })]);
        using RecordingPlayer player = Open(file, new FakeTime());
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        player.Seek(Recordings.At(milliseconds));
        Assert.Equal(Math.Clamp(milliseconds, 0, 4000), player.Position.TotalMilliseconds);
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal(Enumerable.Range(expected, 401 - expected).Select(static index => (uint?)index), frames.Indices);
        Assert.Equal((0, 0), (reader.GetStatistics().SkippedBytes, reader.GetStatistics().Lost));
    }

    [Fact]
    public async Task A_seek_while_it_plays_loses_nothing_and_keeps_the_state()
    {
        using TemporaryFile file = Frames(300, interval: 10);
        using RecordingPlayer player = Open(file, new FakeTime());
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
        Assert.Equal((0, 0, 0, 1), (statistics.Lost, statistics.Restarts, statistics.SkippedBytes, statistics.Reconnects));
        Assert.Equal(
            [ConnectionState.Connecting, ConnectionState.Connected, ConnectionState.Receiving, ConnectionState.Stopped],
            statuses.All.Select(static status => status.State));
        double[] milliseconds = frames.Milliseconds;
        Assert.Equal(milliseconds.Order(), milliseconds);
    }

    [Fact]
    public async Task Each_pass_is_a_connection_and_follows_at_once()
    {
        using TemporaryFile file = Frames(3, interval: 10);
        using RecordingPlayer player = Open(file, new FakeTime());
        player.Passes = 3;
        int completed = 0;
        player.Completed += () => completed++;
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        var statuses = new StatusLog(reader);
        reader.Start();
        await reader.Completion.Soon();

        Assert.Equal([0, 10, 20, 20, 30, 40, 40, 50, 60], frames.Milliseconds);
        Assert.Equal((2, 0, 0), (reader.GetStatistics().Reconnects, reader.GetStatistics().Lost, reader.GetStatistics().Restarts));
        Assert.Equal((3, 1), (player.Pass, completed));
        Assert.Equal(3, statuses.All.Count(static status => status.State == ConnectionState.Connected));
        Assert.All(statuses.All.Where(static status => status.State == ConnectionState.Waiting), static status => Assert.Equal(TimeSpan.Zero, status.RetryIn));
    }

    [Fact]
    public async Task An_endless_loop_ends_when_it_is_told_how_often()
    {
        using var dump = new TemporaryFile(TestPackets.Motions(0, 4));
        using RecordingPlayer player = Open(dump, new FakeTime());
        player.Passes = RecordingPlayer.Endless;
        await using var reader = new NeuronReader(player);
        reader.MotionReceived += _ => player.Passes = player.Pass == 50 ? 50 : player.Passes;
        using var frames = new FrameLog(reader);
        reader.Start();
        await reader.Completion.Soon();

        // A dump's passes follow each other at its rate.
        Assert.Equal(200, frames.Lines.Length);
        Assert.Equal(199 * 1000 / 120.0, frames.Milliseconds[^1], 0.1);
    }

    [Fact]
    public async Task Connections_stand_and_end_when_they_did()
    {
        using TemporaryFile file = Recordings.Write(static writer =>
        {
            writer.OpenConnection(Recordings.At(100), Tcp);
            writer.WriteBytes(Recordings.At(200), 0, TestPackets.Motion(0).AsSpan(0, 777));
            writer.CloseConnection(Recordings.At(300), 0, nameof(ConnectionReason.Reset));
            writer.OpenConnection(Recordings.At(5000), Tcp with { Number = 1 });
            writer.WriteBytes(Recordings.At(6000), 1, TestPackets.Motion(1));
        });
        var time = new FakeTime();
        using RecordingPlayer player = Open(file, time);
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        var statuses = new StatusLog(reader);
        reader.Start();
        await reader.Completion.Soon();

        Assert.Equal([100.0, 200, 300, 5000, 6000], time.Waits.Distinct());
        Assert.Equal([6000.0], frames.Milliseconds);
        Assert.Equal(777, reader.GetStatistics().SkippedBytes);
        Assert.Contains(statuses.All, static status => status is { State: ConnectionState.Waiting, Reason: ConnectionReason.Reset, Message: "The recorded connection ended: Reset." });
        Assert.Equal(2, statuses.All.Count(static status => status.State == ConnectionState.Connected));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task As_fast_as_possible_whoever_awaits_or_pumps_gets_all(bool awaits)
    {
        const int count = 3000;
        using TemporaryFile file = Frames(count, interval: 1000.0 / 120);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        await using var reader = new NeuronReader(player);
        int next = 0;
        if (awaits)
        {
            await foreach (MotionFrame frame in reader.ReadMotionAsync(TestContext.Current.CancellationToken))
                Assert.Equal((uint)next++, frame.FrameIndex);
        }
        else
        {
            using FrameQueue queue = reader.OpenQueue(capacity: 8);
            reader.Start();
            while (!reader.Completion.IsCompleted || queue.Count > 0)
                queue.Pump(frame => Assert.Equal((uint)next++, frame.FrameIndex));
        }

        Assert.Equal((count, 0), (next, reader.GetStatistics().Dropped));
        Assert.Equal(120, reader.GetAvatarStatistics()[0].Rate, 0.1);
        Assert.Equal((count - 1) / 120.0, reader.GetStatistics().Duration.TotalSeconds, 0.001);
    }

    [Fact]
    public async Task A_frame_allocates_nothing()
    {
        using TemporaryFile file = Frames(4000, interval: 8, perPiece: 2);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        await using var reader = new NeuronReader(player);
        (long Before, long After) allocated = default;
        reader.MotionReceived += frame =>
        {
            if (frame.FrameIndex == 2000)
                allocated.Before = GC.GetAllocatedBytesForCurrentThread();
            else if (frame.FrameIndex == 3900)
                allocated.After = GC.GetAllocatedBytesForCurrentThread();
        };
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal(0, allocated.After - allocated.Before);
    }

    [Fact]
    public async Task Without_patience_a_full_queue_drops_as_of_a_live_stream()
    {
        using TemporaryFile file = Frames(100, interval: 10);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        player.WaitsForQueues = false;
        await using var reader = new NeuronReader(player);
        using FrameQueue queue = reader.OpenQueue(capacity: 8);
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal((8, 92), (queue.Count, queue.Dropped));
    }

    [Fact]
    public async Task A_queue_that_nobody_pumps_can_be_given_up_and_the_reader_stopped()
    {
        using TemporaryFile file = Frames(100, interval: 10);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        await using var reader = new NeuronReader(player);
        using FrameQueue queue = reader.OpenQueue(capacity: 8);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 9);
        queue.Dispose();
        using FrameQueue other = reader.OpenQueue(capacity: 2);
        await reader.WaitForFramesAsync(12);
        var watch = Stopwatch.StartNew();
        await reader.DisposeAsync();
        Assert.InRange(watch.Elapsed, TimeSpan.Zero, TimeSpan.FromSeconds(1));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task It_stops_at_once_also_while_paused_and_in_a_long_gap(bool isPaused)
    {
        using TemporaryFile file = Frames(2, interval: 3_600_000);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        await using var reader = new NeuronReader(player);
        reader.Start();
        await reader.WaitForFramesAsync(1);
        if (isPaused)
            player.Pause();

        var watch = Stopwatch.StartNew();
        await reader.DisposeAsync();
        Assert.InRange(watch.Elapsed, TimeSpan.Zero, TimeSpan.FromSeconds(1));
        Assert.Equal(ConnectionReason.Requested, reader.Status.Reason);
    }

    [Fact]
    public async Task Disposing_of_the_player_stops_the_reader()
    {
        using TemporaryFile file = Frames(2, interval: 3_600_000);
        RecordingPlayer player = RecordingPlayer.Open(file.Path);
        await using var reader = new NeuronReader(player);
        reader.Start();
        await reader.WaitForFramesAsync(1);
        player.Dispose();
        await reader.Completion.Soon();
        Assert.Equal(ConnectionReason.EndOfRecording, reader.Status.Reason);
        Assert.Contains("disposed of", reader.Status.Message, StringComparison.Ordinal);
        Assert.Throws<ObjectDisposedException>(() => new NeuronReader(player));
    }

    [Fact]
    public async Task A_paused_playback_is_not_silent_and_a_gap_of_the_recording_is()
    {
        using TemporaryFile file = Frames(2, interval: 3_600_000);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        await using var reader = new NeuronReader(player, new NeuronReaderOptions { SilenceTimeout = TimeSpan.FromSeconds(0.1) });
        var statuses = new StatusLog(reader);
        reader.MotionReceived += _ => player.Pause();
        reader.Start();
        await statuses.WaitAsync(ConnectionState.Receiving);
        await Task.Delay(300, TestContext.Current.CancellationToken);
        Assert.Equal(ConnectionState.Receiving, reader.Status.State);
        player.Resume();
        ConnectionStatus silent = await statuses.WaitAsync(ConnectionState.Silent);
        Assert.Contains("when it was made", silent.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_player_has_one_reader_and_values_in_their_ranges()
    {
        using TemporaryFile file = TenFrames();
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        using var reader = new NeuronReader(player, new NeuronReaderOptions { CommandPort = 8013, Reconnect = { Enabled = false } });
        Assert.Equal($"recording {player.FileName}", reader.Name);
        Assert.Throws<InvalidOperationException>(() => new NeuronReader(player));
        Assert.Throws<ArgumentOutOfRangeException>(() => player.Speed = 0.009);
        Assert.Throws<ArgumentOutOfRangeException>(() => player.Speed = 101);
        Assert.Throws<ArgumentOutOfRangeException>(() => player.Speed = double.NaN);
        Assert.Throws<ArgumentOutOfRangeException>(() => player.Passes = 0);
    }

    [Fact]
    public async Task Controls_may_come_from_any_thread_at_any_time()
    {
        using TemporaryFile file = Frames(2000, interval: 5, perPiece: 2);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Passes = RecordingPlayer.Endless;
        await using var reader = new NeuronReader(player);
        reader.Start();
        Task[] hands = [.. Enumerable.Range(0, 3).Select(seed => Task.Run(() =>
        {
            var random = new Random(seed);
            for (int i = 0; i < 300; i++)
            {
                switch (random.Next(7))
                {
                    case 0: player.Pause(); break;
                    case 1: player.Resume(); break;
                    case 2: player.Step(); break;
                    case 3: player.StepBack(); break;
                    case 4: player.Seek(player.Duration * random.NextDouble()); break;
                    case 5: player.Speed = random.Next(3) == 0 ? RecordingPlayer.MaxSpeed : random.Next(1, 100); break;
                    default: Assert.InRange(player.Position, TimeSpan.Zero, player.Duration); break;
                }

                Preemption.Stumble(random);
            }
        }))];
        await Task.WhenAll(hands).Soon();
        player.Speed = RecordingPlayer.MaxSpeed;
        player.Seek(TimeSpan.Zero);
        player.Resume();
        player.Passes = player.Pass;
        await reader.Completion.Soon();
        Assert.Equal((0, 0, 0), (reader.GetStatistics().SkippedBytes, reader.GetStatistics().Lost, reader.GetStatistics().Gaps));
        Assert.True(reader.GetStatistics().MotionFrames >= 2000);
    }

    private static RecordingPlayer Open(TemporaryFile file, PlaybackTime time)
    {
        PlaybackOptions options = PlaybackOptions.CopyChecked(null);
        return new RecordingPlayer(ArrivalSource.Open(file.Path, options), options, time);
    }

    private static TemporaryFile TenFrames() => Frames(10, interval: 8.3);

    private static TemporaryFile Frames(int count, double interval, int perPiece = 1) => Recordings.OfTcp(
        [.. Enumerable.Range(0, (count + perPiece - 1) / perPiece)
            .Select(piece => (piece * interval, TestPackets.Motions(piece * perPiece, Math.Min(perPiece, count - (piece * perPiece)))))]);
}
