using NeuronMocap.Timing;

namespace NeuronMocap.Tests.Timing;

public sealed class MissingFrameTests
{
    private readonly FrameTiming _timing = new();

    [Fact]
    public void Consecutive_frames_are_one_apart() => Assert.Equal([1, 1, 1], Distances(120, [5, 6, 7]));

    [Fact]
    public void Missing_frames_are_counted() => Assert.Equal([1, 1, 3, 1], Distances(120, [5, 6, 9, 10], [0, 1, 4, 5]));

    [Fact]
    public void Every_second_index_is_a_reduced_frequency() => Assert.Equal([1, 1, 1, 2, 1], Distances(60, [0, 2, 4, 8, 10], [0, 1, 2, 4, 5]));

    [Fact]
    public void A_step_of_more_than_a_reduced_frequency_is_a_gap() => Assert.Equal([1, 300, 1], Distances(120, [0, 300, 301], [0, 300, 301]));

    [Fact]
    public void The_index_wraps() => Assert.Equal([1, 1, 1, 2], Distances(120, [uint.MaxValue - 1, uint.MaxValue, 0, 2], [0, 1, 2, 4]));

    [Fact]
    public void A_late_frame_has_no_distance() => Assert.Equal([1, 1, 2, 0, 1], Distances(120, [5, 6, 8, 7, 9], [0, 1, 3, 3, 4]));

    // They were once mistaken for a restarted server, and the rows after them were doubled.
    [Fact]
    public void Late_frames_that_fill_a_gap_are_no_restart() =>
        Assert.Equal([1, 1, 4, 0, 0, 0, 1], Distances(120, [4, 5, 9, 6, 7, 8, 10], [0, 1, 5, 5, 5, 5, 6]));

    [Fact]
    public void A_restarted_index_loses_no_frames() => Assert.Equal(
        [1, 1, 0, 0, 1, 1, 1, 1, 1], Distances(120, [50, 51, 10, 11, 12, 13, 1_000_000, 1_000_001, 7], [0, 1, 2, 3, 4, 5, 6, 7, 8]));

    [Fact]
    public void An_index_jump_without_a_pause_is_no_loss() => Assert.Equal([1, 1, 1, 1], Distances(120, [5, 6, 5000, 9000]));

    [Fact]
    public void Frames_of_equal_or_missing_index_are_one_apart()
    {
        Assert.Equal([1, 1, 1], Distances(120, [0, 0, 0]));
        Assert.Equal([1, 1, 1], Distances(120, [null, null, null], [3, 4, 5]));
    }

    [Fact]
    public void A_repeated_frame_does_not_change_the_rate()
    {
        for (uint i = 0; i < 400; i++)
        {
            _timing.Add(i, TimeSpan.FromSeconds(i / 60.0), 0);
            if (i % 10 == 3)
                _timing.Add(i, TimeSpan.FromSeconds((i + 0.5) / 60.0), 0);
        }

        Assert.Equal(60, _timing.Rate);
    }

    [Fact]
    public void Distances_apply_the_step_that_is_known_at_the_end()
    {
        Distances(60, [0, 4, 6, 8, 10], [0, 2, 3, 4, 5]);
        Assert.Equal(
            [2, 1, null, null, 1],
            (long?[])[_timing.FramesBetween(0, 4), _timing.FramesBetween(4, 6), _timing.FramesBetween(4, 7), _timing.FramesBetween(6, 4), _timing.FramesBetween(null, 4)]);
    }

    private int[] Distances(double rate, uint?[] indices, int[]? times = null) =>
        [.. indices.Zip(times ?? [.. Enumerable.Range(0, indices.Length)], (index, time) => _timing.Add(index, TimeSpan.FromSeconds(time / rate), 0))];
}
