using System.Diagnostics;
using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Playback;

public sealed class PlaybackClockTests
{
    private const long Start = 1_000_000_000_000;

    [Theory]
    [InlineData(0.01)]
    [InlineData(0.3)]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(100)]
    public void Frames_are_due_without_drift(double speed)
    {
        var clock = new PlaybackClock();
        clock.SetSpeed(speed, Start);
        clock.Run(Start);

        // A tick of the clock is this many ticks of the recording. On Windows and Mono, a tick of the clock is not shorter than one of TimeSpan.
        double tick = speed * TimeSpan.TicksPerSecond / Stopwatch.Frequency;
        for (int frame = 0; frame < 100_000; frame += 777)
        {
            TimeSpan time = TimeSpan.FromTicks(frame * (TimeSpan.TicksPerSecond / 120));
            long due = clock.DueAt(time);
            Assert.InRange(due - After(time.TotalSeconds / speed), -1, 1);
            Assert.InRange((clock.PositionAt(due) - time).Ticks, -2 - tick, 2 + tick);
            Assert.InRange(clock.Reach(time, due + (Stopwatch.Frequency / 2)) - due, -1, 1);
        }
    }

    [Fact]
    public void A_new_speed_counts_from_the_current_position()
    {
        PlaybackClock clock = Running();
        clock.SetSpeed(2, After(10));
        Assert.Equal(TimeSpan.FromSeconds(10), clock.PositionAt(After(10)));
        Assert.Equal(After(11), clock.DueAt(TimeSpan.FromSeconds(12)));
    }

    [Fact]
    public void A_pause_delays_what_follows()
    {
        PlaybackClock clock = Running();
        clock.Halt(After(3));
        Assert.Equal(TimeSpan.FromSeconds(3), clock.PositionAt(After(50)));
        clock.Run(After(50));
        Assert.Equal(After(51), clock.DueAt(TimeSpan.FromSeconds(4)));
    }

    [Fact]
    public void A_delay_over_a_second_shifts_the_rest()
    {
        PlaybackClock clock = Running();
        Assert.Equal(After(1), clock.Reach(TimeSpan.FromSeconds(1), After(1.9)));
        Assert.Equal(After(2), clock.DueAt(TimeSpan.FromSeconds(2)));
        Assert.Equal(After(9), clock.Reach(TimeSpan.FromSeconds(2), After(9)));
        Assert.Equal(After(10), clock.DueAt(TimeSpan.FromSeconds(3)));
    }

    [Fact]
    public void Unpaced_timestamps_keep_the_recorded_intervals()
    {
        PlaybackClock clock = Running();
        clock.SetSpeed(RecordingPlayer.MaxSpeed, Start);
        Assert.Equal(After(10), clock.Reach(TimeSpan.FromSeconds(10), After(0.001)));
        Assert.Equal(After(25), clock.Reach(TimeSpan.FromSeconds(25), After(0.002)));
        Assert.Equal(TimeSpan.FromSeconds(25), clock.PositionAt(After(0.002)));

        clock.MoveTo(TimeSpan.FromSeconds(5), After(0.003));
        Assert.Equal(After(25), clock.Reach(TimeSpan.FromSeconds(5), After(0.003)));
        Assert.Equal(After(26), clock.Reach(TimeSpan.FromSeconds(6), After(0.003)));

        clock.SetSpeed(1, After(0.004));
        Assert.Equal(TimeSpan.FromSeconds(6), clock.PositionAt(After(0.004)));
        Assert.Equal(After(1.004), clock.DueAt(TimeSpan.FromSeconds(7)));
        Assert.Equal(After(27), clock.Reach(TimeSpan.FromSeconds(7), After(1.004)));
    }

    [Fact]
    public void Times_beyond_the_last_are_the_last()
    {
        PlaybackClock clock = Running();
        clock.SetSpeed(0.01, Start);
        Assert.Equal(long.MaxValue, clock.DueAt(TimeSpan.MaxValue));
        clock.SetSpeed(100, Start);
        clock.MoveTo(TimeSpan.FromSeconds(1), Start);
        Assert.InRange(clock.PositionAt(long.MaxValue), TimeSpan.FromDays(365), TimeSpan.MaxValue);
        clock.MoveTo(TimeSpan.MaxValue, Start);
        Assert.Equal(TimeSpan.MaxValue, clock.PositionAt(After(1)));
        clock.Halt(After(1));
        clock.Run(long.MaxValue);
        Assert.Equal((TimeSpan.MaxValue, long.MaxValue), (clock.PositionAt(long.MaxValue), clock.DueAt(TimeSpan.MaxValue)));
    }

    private static PlaybackClock Running()
    {
        var clock = new PlaybackClock();
        clock.Run(Start);
        return clock;
    }

    private static long After(double seconds) => Start + (long)Math.Round(seconds * Stopwatch.Frequency);
}
