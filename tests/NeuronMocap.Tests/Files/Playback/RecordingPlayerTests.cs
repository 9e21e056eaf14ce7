using System.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Playback;

public sealed class RecordingPlayerTests
{
    private static readonly RecordedConnection Tcp = new(0, TransportKind.Tcp, string.Empty, string.Empty);

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(0.5)]
    public async Task Frames_arrive_at_their_times(double speed)
    {
        using TemporaryFile file = Played.TenFrames();
        var time = new FakeTime();
        using RecordingPlayer player = Played.Open(file, time);
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
    public async Task A_new_speed_applies_from_the_current_frame()
    {
        using TemporaryFile file = Played.Frames(5, interval: 100);
        using RecordingPlayer player = Played.Open(file, new FakeTime());
        await using var reader = new NeuronReader(player);
        reader.MotionReceived += frame => player.Speed = frame.FrameIndex == 2 ? 10 : player.Speed;
        using var frames = new FrameLog(reader);
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal([0, 100, 200, 210, 220], frames.Milliseconds);
    }

    [Fact]
    public async Task Each_loop_is_a_new_connection()
    {
        using TemporaryFile file = Played.Frames(3, interval: 10);
        using RecordingPlayer player = Played.Open(file, new FakeTime());
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
    public async Task Setting_a_count_ends_an_endless_loop()
    {
        using var dump = new TemporaryFile(TestPackets.Motions(0, 4));
        using RecordingPlayer player = Played.Open(dump, new FakeTime());
        player.Passes = RecordingPlayer.Endless;
        await using var reader = new NeuronReader(player);
        reader.MotionReceived += _ => player.Passes = player.Pass == 50 ? 50 : player.Passes;
        using var frames = new FrameLog(reader);
        reader.Start();
        await reader.Completion.Soon();

        // Repetitions of a dump follow each other at its rate.
        Assert.Equal(200, frames.Lines.Length);
        Assert.Equal(199 * 1000 / 120.0, frames.Milliseconds[^1], 0.1);
    }

    [Fact]
    public async Task Connections_open_and_close_as_recorded()
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
        using RecordingPlayer player = Played.Open(file, time);
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        var statuses = new StatusLog(reader);
        reader.Start();
        await reader.Completion.Soon();

        Assert.Equal([100.0, 200, 300, 5000, 6000], time.Waits.Distinct());
        Assert.Equal([6000.0], frames.Milliseconds);
        Assert.Equal(777, reader.GetStatistics().BytesSkipped);
        Assert.Contains(statuses.All, static status => status is { State: ConnectionState.Waiting, Reason: ConnectionReason.Reset, Message: "The recorded connection ended: Reset." });
        Assert.Equal(2, statuses.All.Count(static status => status.State == ConnectionState.Connected));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task Every_consumer_gets_every_frame_at_full_speed(bool awaits)
    {
        const int count = 3000;
        using TemporaryFile file = Played.Frames(count, interval: 1000.0 / 120);
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
                queue.Pump<MotionFrame>(frame => Assert.Equal((uint)next++, frame.FrameIndex));
        }

        Assert.Equal((count, 0), (next, reader.GetStatistics().Dropped));
        Assert.Equal(120, reader.GetAvatarStatistics()[0].FrameRate, 0.1);
        Assert.Equal((count - 1) / 120.0, reader.GetStatistics().Duration.TotalSeconds, 0.001);
    }

    [Fact]
    public async Task A_frame_allocates_nothing()
    {
        using TemporaryFile file = Played.Frames(4000, interval: 8, perPiece: 2);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        await using var reader = new NeuronReader(player);
        var marks = new List<long>(20);
        reader.MotionReceived += frame =>
        {
            if (frame.FrameIndex >= 2000 && frame.FrameIndex % 100 == 0)
                marks.Add(GC.GetAllocatedBytesForCurrentThread());
        };
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal(20, marks.Count);
        Assert.Equal(0, marks.Zip(marks.Skip(1), static (before, after) => after - before).Min());
    }

    [Fact]
    public async Task Without_back_pressure_a_full_queue_drops_frames()
    {
        using TemporaryFile file = Played.Frames(100, interval: 10);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        player.WaitForQueues = false;
        await using var reader = new NeuronReader(player);
        using FrameQueue queue = reader.OpenQueue(capacity: 8);
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal((8, 92), (queue.Count, queue.Dropped));
    }

    [Fact]
    public async Task An_unpumped_queue_does_not_block_stopping()
    {
        using TemporaryFile file = Played.Frames(100, interval: 10);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        await using var reader = new NeuronReader(player, new NeuronReaderOptions { StopTimeout = Limits.Unexpected });
        using FrameQueue queue = reader.OpenQueue(capacity: 8);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 9);
        using FrameQueue other = reader.OpenQueue(capacity: 2);
        queue.Dispose();

        // The ninth frame is counted before it reaches the queues, so it may reach the other one.
        await Limits.UntilAsync(() => other.Count == 2 && reader.IsDelivering);
        var watch = Stopwatch.StartNew();
        await reader.DisposeAsync();
        Assert.InRange(watch.Elapsed, TimeSpan.Zero, Limits.Unexpected / 2);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task Stopping_is_immediate_while_paused_and_in_gaps(bool isPaused)
    {
        using TemporaryFile file = Played.Frames(2, interval: 3_600_000);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        await using var reader = new NeuronReader(player, new NeuronReaderOptions { StopTimeout = Limits.Unexpected });
        reader.Start();
        await reader.WaitForFramesAsync(1);
        if (isPaused)
            player.Pause();

        var watch = Stopwatch.StartNew();
        await reader.DisposeAsync();
        Assert.InRange(watch.Elapsed, TimeSpan.Zero, Limits.Unexpected / 2);
        Assert.Equal(ConnectionReason.Requested, reader.Status.Reason);
    }

    [Fact]
    public async Task Disposing_the_player_stops_the_reader()
    {
        using TemporaryFile file = Played.Frames(2, interval: 3_600_000);
        RecordingPlayer player = RecordingPlayer.Open(file.Path);
        await using var reader = new NeuronReader(player);
        reader.Start();
        await reader.WaitForFramesAsync(1);
        player.Dispose();
        await reader.Completion.Soon();
        Assert.Equal(ConnectionReason.EndOfRecording, reader.Status.Reason);
        Assert.Contains("was disposed", reader.Status.Message, StringComparison.Ordinal);
        Assert.Throws<ObjectDisposedException>(() => new NeuronReader(player));
    }

    [Fact]
    public async Task A_pause_is_not_silence_but_a_recorded_gap_is()
    {
        using TemporaryFile file = Played.Frames(2, interval: 3_600_000);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        await using var reader = new NeuronReader(player, new NeuronReaderOptions { SilenceTimeout = TimeSpan.FromSeconds(1) });
        var statuses = new StatusLog(reader);
        reader.MotionReceived += _ => player.Pause();
        reader.Start();
        await statuses.WaitAsync(ConnectionState.Receiving);

        // Another recording that plays on and is silent for as long starts after it, and its silence is reported.
        using TemporaryFile other = Played.Frames(2, interval: 3_600_000);
        using RecordingPlayer playing = RecordingPlayer.Open(other.Path);
        await using var control = new NeuronReader(playing, new NeuronReaderOptions { SilenceTimeout = TimeSpan.FromSeconds(1.5) });
        var controlled = new StatusLog(control);
        control.Start();
        await controlled.WaitAsync(ConnectionState.Silent);
        Assert.Equal(ConnectionState.Receiving, reader.Status.State);
        player.Resume();
        ConnectionStatus silent = await statuses.WaitAsync(ConnectionState.Silent);
        Assert.Contains("while it was recorded", silent.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_player_has_one_reader_and_values_in_their_ranges()
    {
        using TemporaryFile file = Played.TenFrames();
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
        using TemporaryFile file = Played.Frames(2000, interval: 5, perPiece: 2);
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
        Assert.Equal((0, 0, 0), (reader.GetStatistics().BytesSkipped, reader.GetStatistics().Lost, reader.GetStatistics().Gaps));
        Assert.True(reader.GetStatistics().MotionFrames >= 2000);
    }
}
