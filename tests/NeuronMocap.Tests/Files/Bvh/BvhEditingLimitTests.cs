using NeuronMocap.Bvh;

namespace NeuronMocap.Tests.Bvh;

// Times and sizes far beyond those of a take.
public class BvhEditingLimitTests
{
    private static readonly TimeSpan Second = TimeSpan.FromSeconds(1);

    [Fact]
    public void A_part_cannot_end_after_all_time()
    {
        BvhDocument take = Numbered(241, new BvhFrameTime(1, 120));
        Assert.Throws<ArgumentOutOfRangeException>("duration", () => take.Trim(Second, TimeSpan.MaxValue));
        Assert.Throws<ArgumentOutOfRangeException>("duration", () => take.Trim(TimeSpan.FromTicks(-1), TimeSpan.MinValue));
        Assert.Throws<ArgumentOutOfRangeException>("start", () => take.Trim(TimeSpan.MaxValue, TimeSpan.MaxValue));
        Assert.Throws<ArgumentOutOfRangeException>("start", () => take.Trim(TimeSpan.MinValue, TimeSpan.MinValue));
    }

    [Theory]
    [InlineData(1, long.MaxValue)]
    [InlineData(long.MaxValue - 1, long.MaxValue)]
    public void A_time_after_a_take_with_a_large_fraction_is_refused(long numerator, long denominator)
    {
        BvhDocument take = Numbered(5, new BvhFrameTime(numerator, denominator));
        Assert.Throws<ArgumentOutOfRangeException>("start", () => take.Trim(TimeSpan.MaxValue, Second));
        Assert.Throws<ArgumentOutOfRangeException>("start", () => take.Trim(TimeSpan.MinValue, Second));
        Assert.Throws<ArgumentOutOfRangeException>("duration", () => take.Trim(TimeSpan.Zero, TimeSpan.MaxValue));
    }

    [Fact]
    public void A_large_fraction_still_finds_the_nearest_frame()
    {
        // Almost one frame a second.
        BvhDocument take = Numbered(5, new BvhFrameTime(long.MaxValue - 1, long.MaxValue));
        Assert.Equal(take.GetValues(2).ToArray(), take.Trim(2 * Second, 3 * Second).GetValues(0).ToArray());

        // The first frame lasts longer than all time.
        BvhDocument slow = Numbered(5, new BvhFrameTime(long.MaxValue, 1));
        Assert.Equal(0, slow.Trim(TimeSpan.MaxValue, TimeSpan.MaxValue).FrameCount);
    }

    [Fact]
    public void Too_many_joined_frames_are_refused()
    {
        BvhDocument take = Numbered(100_000, BvhFrameTime.Default);
        int most = int.MaxValue / (100_000 * take.ChannelCount);
        Assert.Throws<ArgumentException>("takes", () => BvhEditing.Join([.. Enumerable.Repeat(take, most + 1)]));
        Assert.Throws<ArgumentException>("takes", () => BvhEditing.Join([.. Enumerable.Repeat(take, 22_000)]));
    }

    [Fact]
    public void Too_many_resampled_frames_are_refused()
    {
        BvhDocument day = Numbered(2, new BvhFrameTime(3600, 1));
        Assert.Throws<ArgumentException>(() => day.Resample(1e6));
        Assert.Throws<ArgumentException>(() => day.Resample(default(BvhFrameTime)));
    }

    private static BvhDocument Numbered(int frames, BvhFrameTime time) =>
        new(BvhSamples.Parse(BvhSamples.Hierarchy).Hierarchy, time, [.. Enumerable.Range(0, frames * 9).Select(static i => (float)i)]);
}
