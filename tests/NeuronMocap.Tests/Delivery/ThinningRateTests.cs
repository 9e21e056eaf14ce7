using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

/// <summary>The limit of a rate after pauses, new connections and changes of the server's rate.</summary>
public sealed class ThinningRateTests
{
    // Frames until a new rate is known, as the guide says. Up to a factor of 1.5, a change is small.
    private const int Learning = 50;
    private const int LearningSmallChange = 900;

    private readonly FrameThinner _thinner = new FrameThinning(60, 1).CreateThinner()!;
    private readonly List<(int Frame, double Time)> _taken = [];
    private int _connection;

    [Theory]
    [InlineData(0.3, 1)]
    [InlineData(0.9, 1)]
    [InlineData(0.9, 3)]
    public void A_pause_does_not_change_the_mean_interval(double pause, int pauses)
    {
        Send(0, 600, static frame => frame / 120.0);
        for (int i = 1; i <= pauses; i++)
        {
            int first = 600 * i;
            double shift = i * pause;
            Send(first, 600, frame => (frame / 120.0) + shift);
        }

        AssertSpaced(0, 600 * (pauses + 1), step: 2);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(108)]
    [InlineData(-600)]
    public void A_new_connection_does_not_change_the_mean_interval(int jump)
    {
        Send(0, 600, static frame => frame / 120.0);
        _connection++;
        Send(600 + jump, 600, frame => ((frame - jump) / 120.0) + 0.9);

        // The pause is longer than the wanted interval, so the first frame is taken.
        Assert.Equal([600 + jump, 602 + jump, 604 + jump], _taken.Skip(300).Take(3).Select(static taken => taken.Frame));
        Assert.Equal(600, _taken.Count);
    }

    [Theory]
    [InlineData(60, 120, 0, Learning, 85)]
    [InlineData(60, 120, 0.008, Learning, 85)]
    [InlineData(20, 120, 0, Learning, 85)]
    [InlineData(60, 240, 0, Learning, 98)]
    [InlineData(90, 120, 0, LearningSmallChange, 80)]
    [InlineData(82, 120, 0, LearningSmallChange, 90)]
    public void A_faster_server_is_thinned_by_its_new_rate(double before, double after, double jitter, int learning, int most)
    {
        var random = new Random(1);
        Send(0, 1200, frame => frame / before);
        double start = 1200 / before;
        Send(1200, 2400, frame => start + ((frame - 1200) / after) + (random.NextDouble() * jitter));

        AssertSpaced(1200 + learning, 3600, (int)(after / 60));
        Assert.InRange(CountOfBusiestSecond(), 60, most + 1);
    }

    [Fact]
    public void A_slower_server_is_thinned_by_its_new_rate()
    {
        FrameThinner thinner = new FrameThinning(30, 1).CreateThinner()!;
        Send(thinner, 0, 1200, static frame => frame / 120.0);
        Send(thinner, 1200, 600, static frame => 10 + ((frame - 1200) / 60.0));
        AssertSpaced(0, 1200, step: 4);
        AssertSpaced(1200 + Learning, 1800, step: 2);
    }

    // A network that stops for a moment delivers the frames of that time together. They are not closer in the server's time.
    [Theory]
    [InlineData(0.2)]
    [InlineData(0.5)]
    [InlineData(0.9)]
    [InlineData(3)]
    public void A_backlog_is_thinned_like_the_frames_around_it(double stall)
    {
        Send(0, 3600, frame => frame is >= 1200 && frame < 1200 + (int)(stall * 120) ? 10 + stall : frame / 120.0);
        (int Frame, double Time)[] before = [.. _taken.Where(static taken => taken.Frame < 1200)];
        Assert.Equal(Enumerable.Range(0, 600).Select(static i => 2 * i), before.Select(static taken => taken.Frame));
        int[] steps = [.. _taken.Skip(599).Zip(_taken.Skip(600), static (left, right) => right.Frame - left.Frame)];
        Assert.Equal(Enumerable.Repeat(2, steps.Length), steps);
    }

    [Theory]
    [InlineData(512)]
    [InlineData(2000)]
    public void A_backlog_at_the_start_is_forgotten(int backlog)
    {
        Send(0, backlog, static _ => 0.001);
        Send(backlog, 2400, frame => 0.001 + ((frame - backlog) / 120.0));
        AssertSpaced(backlog + Learning, backlog + 2400, step: 2);
    }

    // The stops are regular, and each is longer than the time after which a frame counts as late.
    [Theory]
    [InlineData(10)]
    [InlineData(20)]
    [InlineData(36)]
    public void Regular_bursts_do_not_count_as_a_new_rate(int burst)
    {
        Send(0, 12_000, frame => frame / burst * burst / 120.0);
        AssertSpaced(2400, 12_000, step: 2);
    }

    private void Send(int first, int count, Func<int, double> arrival) => Send(_thinner, first, count, arrival);

    private void Send(FrameThinner thinner, int first, int count, Func<int, double> arrival)
    {
        for (int frame = first; frame < first + count; frame++)
        {
            double time = arrival(frame);
            byte[] packet = TestPackets.Motion(frame, count: 1);
            if (thinner.Takes(new ReceivedPacket(PacketKind.Motion, packet, (long)(time * Stopwatch.Frequency), PacketOrigin.Create(0, _connection))))
                _taken.Add((frame, time));
        }
    }

    // All frames from one of the first ones on, with the same step.
    private void AssertSpaced(int from, int to, int step)
    {
        int[] frames = [.. _taken.Select(static taken => taken.Frame).Where(frame => frame >= from && frame < to)];
        Assert.InRange(frames[0], from, from + step - 1);
        Assert.Equal(Enumerable.Range(0, (to - frames[0] + step - 1) / step).Select(i => frames[0] + (step * i)), frames);
    }

    private int CountOfBusiestSecond()
    {
        int most = 0;
        for (int first = 0, last = 0; last < _taken.Count; last++)
        {
            while (_taken[last].Time - _taken[first].Time >= 1)
                first++;

            most = Math.Max(most, last - first + 1);
        }

        return most;
    }
}
