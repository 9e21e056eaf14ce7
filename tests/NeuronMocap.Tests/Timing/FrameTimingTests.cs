using NeuronMocap.Timing;

namespace NeuronMocap.Tests.Timing;

public sealed class FrameTimingTests
{
    // Between two frames of a real stream, up to 5 ms more or less than usual pass.
    private const double UsualJitter = 0.005;

    public static TheoryData<int> Rates => [30, 60, 90, 96, 100, 120, 125, 240];

    [Theory, MemberData(nameof(Rates))]
    public void Jitter_does_not_change_the_rate(int rate)
    {
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 2 * rate) { Jitter = UsualJitter }));
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 20 * rate) { Jitter = 2 * UsualJitter }));
    }

    // Frames that a server had ready when the connection opened, or that it sends late because it starts.
    [Theory, MemberData(nameof(Rates))]
    public void An_opening_burst_does_not_change_the_rate(int rate)
    {
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 4 * rate) { Jitter = 0.001, Burst = 0.2 }));
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, rate) { Jitter = 0.001, Burst = 0.07 }));
    }

    [Theory, MemberData(nameof(Rates))]
    public void Lost_frames_do_not_change_the_rate(int rate)
    {
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 5 * rate) { Jitter = UsualJitter, Loss = 0.2 }));
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 5 * rate) { Jitter = UsualJitter, Outage = 1.5 }));
    }

    [Theory, MemberData(nameof(Rates))]
    public void Every_second_frame_is_half_the_rate(int rate)
    {
        var timing = new FrameTiming();
        Add(timing, new ArrivingFrames(rate / 2.0, 3 * rate) { Jitter = UsualJitter, Step = 2, Loss = 0.1 });
        Assert.Equal((2, rate / 2.0), (timing.Step, UsualOrRounded(timing.Rate!.Value)));
    }

    [Theory, MemberData(nameof(Rates))]
    public void A_pause_of_the_server_does_not_change_the_rate(int rate)
    {
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 5 * rate) { Jitter = UsualJitter, Pause = 20 }));
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 5 * rate) { Jitter = UsualJitter, Pause = 0.06, HasIndex = false }));
    }

    [Theory, MemberData(nameof(Rates))]
    public void Streams_without_indices_have_a_rate(int rate) =>
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 3 * rate) { Jitter = UsualJitter, Burst = 0.1, HasIndex = false }));

    [Theory, MemberData(nameof(Rates))]
    public void Two_frames_are_enough(int rate) => Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 2)));

    [Theory, MemberData(nameof(Rates))]
    public void Ten_frames_are_enough(int rate)
    {
        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 10)));
        Assert.Equal(rate == 125 ? 120 : rate, RateOf(new ArrivingFrames(rate, 10) { Jitter = 0.0005 }));
    }

    // The frames of each connection begin with a burst.
    [Theory, MemberData(nameof(Rates))]
    public void Connections_do_not_change_the_rate(int rate)
    {
        var timing = new FrameTiming();
        for (int connection = 0; connection < 3; connection++)
        {
            foreach ((uint? index, TimeSpan time) in new ArrivingFrames(rate, 2 * rate) { Jitter = UsualJitter, Burst = 0.07 }.Frames())
                timing.Add(index, time + TimeSpan.FromSeconds(60 * connection), connection);
        }

        Assert.Equal(rate, timing.Rate);
    }

    [Theory]
    [InlineData(95.9, 96)]
    [InlineData(59.94, 60)]
    [InlineData(101, 100)]
    [InlineData(119.1, 120)]
    [InlineData(110, 110)]
    [InlineData(12.34, 12.34)]
    public void A_measured_rate_snaps_to_a_usual_one(double rate, double expected)
    {
        var timing = new FrameTiming();
        Add(timing, new ArrivingFrames(rate, 3000) { Jitter = 0.001 });
        Assert.Equal(expected, timing.Rate!.Value, 0.0101);
        Assert.Equal(Math.Round(timing.Rate.Value, 2), timing.Rate);
        Assert.InRange(timing.MeasuredRate!.Value, rate * 0.999, rate * 1.001);
    }

    [Theory]
    [InlineData(60)]
    [InlineData(90)]
    [InlineData(125)]
    [InlineData(59.94)]
    [InlineData(97.3)]
    [InlineData(59.94005994005994)]
    [InlineData(1000)]
    [InlineData(0.5)]
    public void Even_times_give_the_exact_rate(double rate)
    {
        foreach (int count in (int[])[3, 10, 1000])
        {
            Assert.Equal(rate, RateOf(new ArrivingFrames(rate, count)), rate * (count < 10 ? 1e-4 : 1e-12));
            Assert.Equal(rate, RateOf(new ArrivingFrames(rate, count) { Step = 3 }), rate * (count < 10 ? 1e-4 : 1e-12));
        }

        Assert.Equal(rate, RateOf(new ArrivingFrames(rate, 1000) { Loss = 0.2 }), rate * 1e-12);
    }

    [Theory]
    [InlineData(59.941257567583767)] // 0.016683 s
    [InlineData(100.123456789)]
    public void An_unusual_even_rate_reproduces_the_times(double rate)
    {
        double found = RateOf(new ArrivingFrames(rate, 5000));
        foreach (((_, TimeSpan expected), (_, TimeSpan actual)) in new ArrivingFrames(rate, 5000).Frames().Zip(new ArrivingFrames(found, 5000).Frames()))
            Assert.InRange((expected - actual).Ticks, -1, 1);
    }

    [Fact]
    public void There_is_no_rate_without_times()
    {
        var timing = new FrameTiming();
        Assert.Equal((null, null, 1), (timing.Rate, timing.MeasuredRate, timing.Step));
        timing.Add(5, TimeSpan.FromSeconds(1), 0);
        Assert.Null(timing.Rate);
        for (uint i = 6; i < 50; i++)
            timing.Add(i, TimeSpan.FromSeconds(1), 0);
        Assert.Equal((null, null), (timing.Rate, timing.MeasuredRate));

        var backwards = new FrameTiming();
        for (uint i = 0; i < 50; i++)
            backwards.Add(i, TimeSpan.FromSeconds(-i), 0);
        Assert.Equal((null, null), (backwards.Rate, backwards.MeasuredRate));
    }

    // A BVH file cannot hold a higher rate.
    [Fact]
    public void The_rate_is_at_most_a_million()
    {
        var timing = new FrameTiming();
        for (uint i = 0; i < 1000; i++)
            timing.Add(i, TimeSpan.FromTicks(i / 2), 0);

        Assert.Equal(1e6, timing.Rate);
    }

    [Fact]
    public void Adding_and_measuring_allocate_nothing()
    {
        var timing = new FrameTiming();
        uint index = 0;
        double rate = 0;
        Allocations.AssertNone(() =>
        {
            timing.Add(index++, TimeSpan.FromSeconds((index / 60.0) + (index * 7 % 5 / 1000.0)), 0);
            rate = timing.Rate ?? 0;
        });
        Assert.Equal(60, rate);
    }

    private static double UsualOrRounded(double rate) => Math.Abs(rate - Math.Round(rate * 2) / 2) < 0.1 ? Math.Round(rate * 2) / 2 : rate;

    private static double RateOf(ArrivingFrames frames)
    {
        var timing = new FrameTiming();
        Add(timing, frames);
        return timing.Rate!.Value;
    }

    private static void Add(FrameTiming timing, ArrivingFrames frames)
    {
        foreach ((uint? index, TimeSpan time) in frames.Frames())
            timing.Add(index, time, 0);
    }
}
