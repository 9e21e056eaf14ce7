using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Playback;

public sealed class ManualClockTests
{
    private readonly ManualClock _clock = new();

    [Fact]
    public async Task Frames_are_due_on_the_clock()
    {
        using TemporaryFile file = Played.Frames(10, interval: 10);
        using RecordingPlayer player = Open(file);
        await using var reader = new NeuronReader(player);
        var frames = new List<(uint? Index, long Timestamp)>();
        reader.MotionReceived += frame => frames.Add((frame.FrameIndex, frame.Timestamp));
        Assert.True(player.WaitUntilDelivered(TimeSpan.Zero));
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 1);

        foreach (int milliseconds in (int[])[4, 10, 45, 45, 46, 60])
        {
            _clock.MoveTo(Recordings.At(milliseconds));
            Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
            Assert.Equal((milliseconds / 10) + 1, frames.Count);
            Assert.Equal(Recordings.At(milliseconds), player.Position);
        }

        Assert.Equal([0, 1, 2, 3, 4, 5, 6], frames.Select(static frame => (int)frame.Index!));
        double[] times = [.. frames.Select(frame => (frame.Timestamp - frames[0].Timestamp) * 1000.0 / System.Diagnostics.Stopwatch.Frequency)];
        Assert.Equal([0, 10, 20, 30, 40, 50, 60], times.Select(static time => Math.Round(time, 2)));
        Assert.Equal(_clock.Timestamp, frames[^1].Timestamp);
    }

    [Fact]
    public async Task A_long_step_leaves_nothing_out()
    {
        using TemporaryFile file = Played.Frames(400, interval: 10);
        using RecordingPlayer player = Open(file);
        player.Passes = 3;
        await using var reader = new NeuronReader(player);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 1);

        _clock.MoveTo(Recordings.At((2 * 3990) + 1000));
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.Equal(400 + 400 + 101, reader.GetStatistics().MotionFrames);

        _clock.MoveTo(TimeSpan.FromHours(1));
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        await reader.Completion.Soon();
        Assert.Equal(1200, reader.GetStatistics().MotionFrames);
        Assert.True(player.WaitUntilDelivered(TimeSpan.Zero));
    }

    [Fact]
    public async Task A_wait_ends_with_its_time_or_with_the_handlers()
    {
        using TemporaryFile file = Played.Frames(10, interval: 10);
        using RecordingPlayer player = Open(file);
        await using var reader = new NeuronReader(player);
        using ManualResetEventSlim going = await StartWithHandlerThatWaitsAsync(reader);

        _clock.MoveTo(Recordings.At(25));
        Assert.False(player.WaitUntilDelivered(TimeSpan.Zero));
        going.Set();
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.Equal(3, reader.GetStatistics().MotionFrames);
    }

    [Fact]
    public async Task A_paused_or_stopped_playback_has_nothing_to_wait_for()
    {
        using TemporaryFile file = Played.Frames(10, interval: 10);
        using RecordingPlayer player = Open(file);
        await using var reader = new NeuronReader(player);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 1);
        player.Pause();
        _clock.MoveTo(Recordings.At(50));
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.Equal(1, reader.GetStatistics().MotionFrames);

        player.Seek(Recordings.At(70));
        player.Resume();
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.Equal(2, reader.GetStatistics().MotionFrames);

        // The clock stands still, and the reader ends all the same.
        await reader.DisposeAsync().AsTask().Soon();
        _clock.MoveTo(TimeSpan.FromHours(1));
        Assert.True(player.WaitUntilDelivered(TimeSpan.Zero));
    }

    [Fact]
    public void The_clock_never_goes_back()
    {
        _clock.MoveTo(TimeSpan.FromSeconds(2));
        long timestamp = _clock.Timestamp;
        _clock.MoveTo(TimeSpan.FromSeconds(1));
        Assert.Equal((TimeSpan.FromSeconds(2), timestamp), (_clock.Now, _clock.Timestamp));
    }

    [Fact]
    public async Task The_last_time_of_all_makes_every_frame_due()
    {
        using TemporaryFile file = Played.Frames(10, interval: 10);
        using RecordingPlayer player = Open(file);
        player.Speed = 100;
        player.Passes = 2;
        await using var reader = new NeuronReader(player);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 1);
        long before = _clock.Timestamp;
        _clock.MoveTo(TimeSpan.MaxValue);
        Assert.InRange(_clock.Timestamp, before + 1, long.MaxValue);
        Assert.InRange(player.Position, TimeSpan.Zero, player.Duration);
        await reader.Completion.Soon();
        Assert.Equal(20, reader.GetStatistics().MotionFrames);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_wait_can_have_no_limit(bool isInfinite)
    {
        using TemporaryFile file = Played.Frames(10, interval: 10);
        using RecordingPlayer player = Open(file);
        await using var reader = new NeuronReader(player);
        using ManualResetEventSlim going = await StartWithHandlerThatWaitsAsync(reader);
        _clock.MoveTo(Recordings.At(25));

        bool? delivered = null;
        var waiter = new Thread(() => delivered = player.WaitUntilDelivered(isInfinite ? Timeout.InfiniteTimeSpan : TimeSpan.MaxValue)) { IsBackground = true };
        waiter.Start();
        await Limits.UntilAsync(() => waiter.ThreadState.HasFlag(ThreadState.WaitSleepJoin) || !waiter.IsAlive);
        going.Set();
        Assert.True(waiter.Join(Limits.Unexpected));
        Assert.True(delivered);
        Assert.Equal(3, reader.GetStatistics().MotionFrames);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(-2 * TimeSpan.TicksPerMillisecond)]
    [InlineData(long.MinValue)]
    public void A_wait_is_not_negative(long ticks)
    {
        using TemporaryFile file = Played.TenFrames();
        using RecordingPlayer player = Open(file);
        Assert.Throws<ArgumentOutOfRangeException>("timeout", () => player.WaitUntilDelivered(new TimeSpan(ticks)));
    }

    // The handler waits for the event at the second frame.
    private static async Task<ManualResetEventSlim> StartWithHandlerThatWaitsAsync(NeuronReader reader)
    {
        var going = new ManualResetEventSlim();
        reader.MotionReceived += frame =>
        {
            if (frame.FrameIndex == 1)
                going.Wait();
        };
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 1);
        return going;
    }

    private RecordingPlayer Open(TemporaryFile file) => RecordingPlayer.Open(file.Path, new PlaybackOptions { Clock = _clock });
}
