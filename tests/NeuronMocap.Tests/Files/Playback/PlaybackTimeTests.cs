using System.Diagnostics;
using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Playback;

public sealed class PlaybackTimeTests
{
    // One wait ends just before the instant, and the next at it. A wait may end early, but not again and again.
    [Theory]
    [InlineData(0.1)]
    [InlineData(5)]
    [InlineData(40)]
    public void Few_waits_lead_to_the_instant_and_the_gate_is_held_again(double milliseconds)
    {
        object gate = new();
        PlaybackTime time = PlaybackTime.Real;
        lock (gate)
        {
            long instant = time.Now + (long)(milliseconds * Stopwatch.Frequency / 1000);
            int waits = 0;
            for (; time.Now < instant; waits++)
                time.Wait(gate, instant);

            Assert.True(Monitor.IsEntered(gate));
            Assert.InRange(waits, 0, 50);
        }
    }

    // The frequency of Windows.
    [Fact]
    public void A_recorded_time_keeps_every_tick() => Assert.DoesNotContain(
        Enumerable.Range(0, 1_000_001), static ticks => RecordedTime.ToTimestamp(TimeSpan.FromTicks(ticks), frequency: 10_000_000) != ticks);

    [Fact]
    public void A_precise_sleep_lasts_at_least_its_time()
    {
        Assert.SkipUnless(PreciseSleep.IsAvailable, "This system has no precise sleep.");
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < 20; i++)
            PreciseSleep.Sleep(Stopwatch.Frequency / 1000);

        Assert.True(PreciseSleep.IsAvailable);
        Assert.True(Stopwatch.GetTimestamp() - start > Stopwatch.Frequency / 100);
    }
}
