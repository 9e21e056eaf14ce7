using NeuronMocap.Frames;

namespace NeuronMocap.Tests.Frames;

public sealed class IndexTrackerTests
{
    private readonly IndexTracker _tracker = new();

    [Theory]
    [InlineData(new uint[] { 5, 6, 7 }, 0)]
    [InlineData(new uint[] { 5, 8 }, 1)]
    [InlineData(new uint[] { 5, 8, 9, 11 }, 2)]
    [InlineData(new uint[] { 5, 7, 6 }, 0)]
    [InlineData(new uint[] { 5, 9, 8 }, 1)]
    [InlineData(new uint[] { 5, 9, 7 }, 2)]
    [InlineData(new uint[] { 5, 9, 7, 6, 8 }, 0)]
    [InlineData(new uint[] { uint.MaxValue, 1, 3, 2 }, 1)]
    public void A_gap_is_a_run_of_missing_frames(uint[] indices, long gaps)
    {
        Feed(indices);
        Assert.Equal(gaps, _tracker.Gaps);
    }

    [Theory]
    [InlineData(new uint[] { 1000, 1, 2 }, 1)]
    [InlineData(new uint[] { 48, 49, 0, 1, 2, 3 }, 1)]
    [InlineData(new uint[] { 1, 1_000_000, 1_000_001 }, 1)]
    [InlineData(new uint[] { 40, 42, 44, 0, 2, 4, 6 }, 1)]
    [InlineData(new uint[] { 1000, 1, 2, 100_000, 100_001 }, 2)]
    [InlineData(new uint[] { 5, 4, 6, 5, 7 }, 0)]
    [InlineData(new uint[] { uint.MaxValue - 1, uint.MaxValue, 0, 1, 2 }, 0)]
    [InlineData(new uint[] { uint.MaxValue - 1, 2 }, 0)]
    public void A_restart_is_no_gap_wrap_or_late_frame(uint[] indices, long restarts)
    {
        Feed(indices);
        Assert.Equal(restarts, _tracker.Restarts);
    }

    [Fact]
    public void Each_index_is_classified()
    {
        uint?[] indices = [7, 8, 8, 12, 10, null, 5, 6, 1_000_000, 1_000_001, 999_990, 999_991, 999_992];
        Assert.Equal(
            [
                IndexChange.None, IndexChange.Ahead, IndexChange.Same, IndexChange.Ahead, IndexChange.Late, IndexChange.None, IndexChange.None, IndexChange.Ahead,
                IndexChange.Restart, IndexChange.Ahead, IndexChange.Late, IndexChange.Late, IndexChange.Restart,
            ],
            indices.Select(_tracker.OnIndex));
        Assert.Equal(999_992u, _tracker.Newest);
    }

    // One datagram overtakes a burst: three arrive late, in order, each into its gap. This was once mistaken for a restart.
    [Fact]
    public void Late_frames_that_fill_a_gap_are_no_restart()
    {
        Feed([5, 9, 6, 7, 8, 10]);
        Assert.Equal((0, 0, 3, 0), (_tracker.Lost, _tracker.Gaps, _tracker.OutOfOrder, _tracker.Restarts));
    }

    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    [InlineData(60)]
    public void A_reduced_frequency_loses_nothing(int step)
    {
        Feed(Steps(uint.MaxValue - 100, 100, step));
        Assert.Equal((0, 0, 0, 0, step), (_tracker.Lost, _tracker.Gaps, _tracker.Restarts, _tracker.Unsettled, _tracker.Step));
    }

    [Fact]
    public void Loss_is_unsettled_until_the_steps_are_known()
    {
        Feed(Steps(0, 10, 3));
        Assert.Equal((18, 18), (_tracker.Lost, _tracker.Unsettled));
        Feed([28]);
        Assert.Equal((18, 0, 1), (_tracker.Lost, _tracker.Unsettled, _tracker.Step));
    }

    [Fact]
    public void Loss_at_a_reduced_frequency_counts_sent_frames()
    {
        Feed([.. Steps(0, 50, 2), 104, 106, 108]);
        Assert.Equal((2, 1, 2), (_tracker.Lost, _tracker.Gaps, _tracker.Step));
    }

    [Fact]
    public void A_reduced_frequency_is_found_despite_loss_and_reordering()
    {
        uint[] sent = Steps(1000, 198, 2);
        List<uint> received = [.. sent.Where((_, i) => i % 7 != 3)];
        (received[4], received[5]) = (received[5], received[4]);
        Feed(received);
        Assert.Equal((sent.Length - received.Count, 2), (_tracker.Lost, _tracker.Step));
    }

    // Each pair steps by 3, then back by 1. Late frames were sent, so the even steps are not a reduced frequency, and real losses stay.
    [Fact]
    public void Swapped_neighbours_are_no_reduced_frequency()
    {
        Feed([0, .. Enumerable.Range(1, 100).Select(i => (uint)i * 10).SelectMany(i => Enumerable.Range(1, 9).Select(n => i - 10 + (uint)n)), 1000]);
        Assert.Equal((99, 99), (_tracker.Lost, _tracker.Gaps));
        Feed(Enumerable.Range(0, 40).SelectMany(i => (uint[])[1002 + (2 * (uint)i), 1001 + (2 * (uint)i)]));
        Assert.Equal((99, 99, 40, 1), (_tracker.Lost, _tracker.Gaps, _tracker.OutOfOrder, _tracker.Step));
    }

    [Fact]
    public void Frequency_changes_are_no_loss()
    {
        var indices = new List<uint>();
        uint next = 7;
        foreach (int step in (int[])[1, 2, 1, 3, 2, 4, 1])
        {
            for (int i = 0; i < 40; i++)
                indices.Add(next += (uint)step);
        }

        Feed(indices);
        Assert.Equal((0, 0, 0, 1), (_tracker.Lost, _tracker.Gaps, _tracker.Restarts, _tracker.Step));
    }

    // Each n-th frame lost, two of three lost, bursts of up to five. None of these patterns stays even for long.
    [Theory]
    [InlineData(10, 1)]
    [InlineData(3, 1)]
    [InlineData(7, 5)]
    [InlineData(40, 39)]
    public void Periodic_loss_at_full_rate_is_not_hidden(int period, int lost)
    {
        uint[] received = [.. Enumerable.Range(0, 2000).Where(i => i % period >= lost || (period - lost == 1 && i % 15 == 0)).Select(i => (uint)i)];
        Feed(received);
        Assert.Equal((received[^1] - received[0] + 1 - received.Length, 1), (_tracker.Lost, _tracker.Step));
    }

    [Fact]
    public void The_sixteenth_even_step_proves_a_reduced_frequency()
    {
        Feed(Steps(0, 16, 2));
        Assert.Equal((15, 15, 1), (_tracker.Lost, _tracker.Gaps, _tracker.Step));
        Feed([32]);
        Assert.Equal((0, 0, 2), (_tracker.Lost, _tracker.Gaps, _tracker.Step));
    }

    // Compared with the plainest model: what was sent, and which of it arrived. Random steps, starts, losses, bursts, swaps and copies.
    [Fact]
    public void Random_streams_match_a_simple_count()
    {
        for (int seed = 0; seed < 400; seed++)
        {
            var random = new Random(seed);
            int step = random.Next(1, 7);
            uint first = random.Next(3) == 0 ? uint.MaxValue - (uint)random.Next(2000) : (uint)random.Next();
            bool[] arrives = Arrivals(random, 600);
            int[] order = Swapped(random, [.. Enumerable.Range(0, arrives.Length).Where(i => arrives[i])]);

            var tracker = new IndexTracker();
            tracker.StartAt(first);
            for (int i = 1; i < order.Length; i++)
                tracker.OnIndex(first + (uint)(order[i] * step));

            int newest = order.Max();
            int lost = arrives.Take(newest).Count(arrived => !arrived);
            int gaps = Enumerable.Range(1, newest).Count(i => arrives[i] && !arrives[i - 1]);
            Assert.True(
                (lost, gaps, 0L, step) == (tracker.Lost, tracker.Gaps, tracker.Restarts, tracker.Step),
                $"seed {seed}: {lost} lost in {gaps} gaps by {step}, counted {tracker.Lost} in {tracker.Gaps} by {tracker.Step}, {tracker.Restarts} restarts");
        }
    }

    // Random loss of up to every other frame never looks like a reduced frequency.
    [Theory]
    [InlineData(0.01)]
    [InlineData(0.2)]
    [InlineData(0.5)]
    public void Random_loss_at_full_rate_is_counted_exactly(double probability)
    {
        var random = new Random(7001);
        uint[] received = [0, .. Enumerable.Range(1, 200_000).Where(_ => random.NextDouble() >= probability).Select(i => (uint)i)];
        Feed(received);
        Assert.Equal((received[^1] + 1 - received.Length, 1), (_tracker.Lost, _tracker.Step));
    }

    [Fact]
    public void Counting_allocates_nothing()
    {
        uint index = 0;
        Allocations.AssertNone(() => _tracker.OnIndex(index += index % 50 == 0 ? 3u : 1u));
    }

    private void Feed(IEnumerable<uint> indices)
    {
        bool started = _tracker.Step != 1 || _tracker.Lost > 0;
        foreach (uint index in indices)
        {
            if (!started)
                _tracker.StartAt(index);
            else
                _tracker.OnIndex(index);

            started = true;
        }
    }

    private static uint[] Steps(uint first, int count, int step) => [.. Enumerable.Range(0, count).Select(i => first + (uint)(i * step))];

    // The first 40 frames arrive, so that the step is known. Then there are single losses and bursts. The last frame arrives.
    private static bool[] Arrivals(Random random, int count)
    {
        bool[] arrives = [.. Enumerable.Repeat(element: true, count)];
        for (int i = 40; i < count - 1; i++)
        {
            int burst = random.Next(20) == 0 ? random.Next(1, 6) : 0;
            for (int end = Math.Min(i + burst, count - 1); i < end; i++)
                arrives[i] = false;
        }

        return arrives;
    }

    // Some neighbours are swapped. No frame moves by more than one place.
    private static int[] Swapped(Random random, int[] order)
    {
        for (int i = 40; i + 1 < order.Length; i++)
        {
            if (random.Next(10) == 0)
            {
                (order[i], order[i + 1]) = (order[i + 1], order[i]);
                i++;
            }
        }

        return order;
    }
}
