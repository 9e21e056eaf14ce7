using System.Diagnostics;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Tests;

public sealed class FrameClockTests
{
    private const long Start = 1_000_000_000_000;

    [Theory]
    [InlineData(60)]
    [InlineData(120)]
    [InlineData(59.94)]
    [InlineData(0.01)]
    [InlineData(2000)]
    public void A_frame_is_due_at_its_own_time_without_drift(double rate)
    {
        var clock = new FrameClock(rate, Start);
        foreach (long frame in (long[])[0, 1, 2, 1000, 1_000_001, 100_000_000])
        {
            long due = Start + (long)(frame * (Stopwatch.Frequency / rate));
            Assert.Equal(0, clock.GetDelay(frame, due));
            Assert.Equal(1, clock.GetDelay(frame, due - 1));
            Assert.Equal(3, clock.GetDelay(frame, due - (Stopwatch.Frequency * 3 / 1000)));
        }
    }

    [Fact]
    public void A_late_wake_up_does_not_delay_later_frames()
    {
        var clock = new FrameClock(100, Start);
        Assert.Equal(0, clock.GetDelay(1, At(0.025)));
        Assert.Equal(0, clock.GetDelay(2, At(0.025)));
        Assert.Equal(5, clock.GetDelay(3, At(0.025)));
    }

    [Theory]
    [InlineData(60, 4)]
    [InlineData(1, 4)]
    [InlineData(1000, 20)]
    public void A_pause_is_followed_by_few_frames_at_once_and_the_rate(double rate, int tolerated)
    {
        var clock = new FrameClock(rate, Start);
        long now = At(1000 / rate);
        long frame = 10;
        while (clock.GetDelay(frame, now) == 0)
            frame++;

        Assert.InRange(frame - 10, tolerated, tolerated + 2);
        long next = now + (long)(Stopwatch.Frequency / rate);
        Assert.Equal(0, clock.GetDelay(frame, next));
        Assert.NotEqual(0, clock.GetDelay(frame + 1, next));
    }

    private static long At(double seconds) => Start + (long)(seconds * Stopwatch.Frequency);
}
