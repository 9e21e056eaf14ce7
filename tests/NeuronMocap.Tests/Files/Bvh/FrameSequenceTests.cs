using System.Diagnostics;
using NeuronMocap.Bvh;

namespace NeuronMocap.Tests.Bvh;

public class FrameSequenceTests
{
    private readonly FrameSequence _sequence = new(BvhGapHandling.Repeat);

    [Fact]
    public void Consecutive_frames_are_a_row_each() => Assert.Equal([1, 1, 1], Rows(120, [5, 6, 7]));

    [Fact]
    public void Missing_frames_are_repeated() => Assert.Equal([1, 1, 3, 1], Rows(120, [5, 6, 9, 10], [0, 1, 4, 5]));

    [Fact]
    public void Missing_frames_can_be_left_out() =>
        Assert.Equal([1, 1, 1, 1], Rows(new FrameSequence(BvhGapHandling.Skip), 120, [5, 6, 9, 10], [0, 1, 4, 5]));

    [Fact]
    public void Every_second_index_is_a_reduced_frequency() =>
        Assert.Equal([1, 1, 1, 2, 1], Rows(60, [0, 2, 4, 8, 10], [0, 1, 2, 4, 5]));

    [Fact]
    public void The_index_wraps() => Assert.Equal([1, 1, 1, 2], Rows(120, [uint.MaxValue - 1, uint.MaxValue, 0, 2], [0, 1, 2, 4]));

    [Fact]
    public void A_late_frame_was_already_replaced() => Assert.Equal([1, 1, 2, 0, 1], Rows(120, [5, 6, 8, 7, 9], [0, 1, 3, 3, 4]));

    // They were once mistaken for a restarted server, and the rows after them were doubled.
    [Fact]
    public void Late_frames_that_fill_a_gap_are_no_restart() =>
        Assert.Equal([1, 1, 4, 0, 0, 0, 1], Rows(120, [4, 5, 9, 6, 7, 8, 10], [0, 1, 5, 5, 5, 5, 6]));

    [Fact]
    public void A_restarted_index_loses_no_frames() => Assert.Equal(
        [1, 1, 0, 0, 1, 1, 1, 1, 1], Rows(120, [50, 51, 10, 11, 12, 13, 1_000_000, 1_000_001, 7], [0, 1, 2, 3, 4, 5, 6, 7, 8]));

    [Fact]
    public void An_index_jump_without_a_pause_is_no_loss() => Assert.Equal([1, 1, 1, 1], Rows(120, [5, 6, 5000, 9000]));

    [Fact]
    public void Frames_of_equal_or_missing_index_are_a_row_each()
    {
        Assert.Equal([1, 1, 1], Rows(120, [0, 0, 0]));
        Assert.Equal([1, 1, 1], Rows(new FrameSequence(BvhGapHandling.Repeat), 120, [null, null, null], [0, 1, 2]));
    }

    [Theory]
    [InlineData(120, 120)]
    [InlineData(95.9, 96)]
    [InlineData(59.94, 60)]
    [InlineData(101, 100)]
    [InlineData(110, 110)]
    [InlineData(12.34, 12.34)]
    public void The_measured_rate_snaps_to_a_usual_one(double rate, double expected)
    {
        Rows(rate, [.. Enumerable.Range(0, 2000).Select(static i => (uint?)i)]);
        Assert.Equal(expected, _sequence.Measure().FrameRate, 1e-6);
    }

    // The intervals of a real stream: a few milliseconds more or less, and sometimes two frames at once.
    [Fact]
    public void Jitter_does_not_change_the_rate()
    {
        var random = new Random(1);
        for (uint i = 0; i < 100; i++)
            _sequence.Next(i, Ticks((i / 95.9) + (random.NextDouble() * 0.012)));

        Assert.Equal(96, _sequence.Measure().FrameRate, 1e-6);
    }

    [Fact]
    public void A_long_burst_at_the_start_does_not_change_the_rate()
    {
        for (uint i = 0; i < 200; i++)
            _sequence.Next(i, Ticks(Math.Max(0.2, i / 60.0)));

        Assert.Equal(60, _sequence.Measure().FrameRate, 1e-6);
    }

    // Frames that a server had ready when the connection opened.
    [Fact]
    public void A_burst_at_the_start_of_a_short_take_does_not_change_the_rate()
    {
        for (uint i = 0; i < 50; i++)
            _sequence.Next(i, Ticks(Math.Max(0.05, i / 60.0)));

        Assert.Equal(60, _sequence.Measure().FrameRate, 1e-6);
    }

    // The server's clock starts, and then the server catches up on the time that its start took.
    [Fact]
    public void Servers_that_start_mid_take_do_not_change_the_rate()
    {
        for (int run = 0; run < 3; run++)
        {
            _sequence.Restart();
            for (uint i = 0; i < 100; i++)
                _sequence.Next(i, Ticks((10 * run) + Math.Max(0.07, i / 60.0)));
        }

        Assert.Equal(60, _sequence.Measure().FrameRate, 1e-6);
    }

    [Fact]
    public void Losses_pauses_and_restarts_do_not_change_the_rate()
    {
        double time = 0;
        for (uint i = 0; i < 500; i++)
        {
            time += 1 / 60.0;
            if (i is 100)
                time += 20;
            if (i is not (>= 200 and < 230) && i % 7 != 3)
                _sequence.Next(i < 100 ? i : i + 100_000, Ticks(time));
        }

        Assert.Equal(60, _sequence.Measure().FrameRate, 1e-6);
    }

    [Fact]
    public void The_rate_defaults_to_axis_neurons_below_two_frames()
    {
        Assert.Equal(BvhFrameTime.Default, _sequence.Measure());
        _sequence.Next(1, 0);
        _sequence.Next(2, 0);
        Assert.Equal(BvhFrameTime.Default, _sequence.Measure());
    }

    private static long Ticks(double seconds) => (long)(seconds * Stopwatch.Frequency);

    private static int[] Rows(FrameSequence sequence, double rate, uint?[] indices, int[] times) =>
        [.. indices.Zip(times, (index, time) => sequence.Next(index, Ticks(time / rate)))];

    private int[] Rows(double rate, uint?[] indices, int[]? times = null) =>
        Rows(_sequence, rate, indices, times ?? [.. Enumerable.Range(0, indices.Length)]);
}
