using System.Diagnostics;
using NeuronMocap.Delivery;

namespace NeuronMocap.Tests.Delivery;

public sealed class AvatarTrackerTests
{
    private readonly AvatarTracker _tracker = new(PacketKind.Motion, origin: 0, avatar: 2);

    [Theory]
    [InlineData(new uint[] { 5, 6, 7 }, 0, 0)]
    [InlineData(new uint[] { 5, 8 }, 2, 0)]
    [InlineData(new uint[] { uint.MaxValue - 1, uint.MaxValue, 0, 1 }, 0, 0)]
    [InlineData(new uint[] { uint.MaxValue, 2 }, 2, 0)]
    [InlineData(new uint[] { 5, 5, 6 }, 0, 1)]
    [InlineData(new uint[] { 5, 7, 6, 8 }, 0, 1)]
    [InlineData(new uint[] { 5, 9, 7, 7, 10 }, 2, 2)]
    [InlineData(new uint[] { 5, 9, 8, 6, 7, 10 }, 0, 3)]
    [InlineData(new uint[] { 1000, 1, 2 }, 0, 0)]
    [InlineData(new uint[] { 48, 49, 0, 1, 2, 3, 5, 6 }, 1, 0)]
    [InlineData(new uint[] { 20, 22, 0, 1, 2, 3 }, 1, 0)]
    [InlineData(new uint[] { 1, 1_000_000, 1_000_001 }, 0, 0)]
    public void Gaps_repetitions_late_frames_and_restarts_are_distinguished(uint[] indices, long lost, long disordered)
    {
        foreach (uint index in indices)
            _tracker.OnFrame(new byte[32], index, timestamp: 1);

        Assert.Equal((indices.Length, lost, disordered), (_tracker.Snapshot.Frames, _tracker.Snapshot.Lost, _tracker.Snapshot.OutOfOrder));
    }

    [Fact]
    public void A_header_without_an_index_loses_nothing()
    {
        for (int i = 0; i < 3; i++)
            _tracker.OnFrame(new byte[32], index: null, timestamp: i);

        Assert.Equal((3, 0), (_tracker.Snapshot.Frames, _tracker.Snapshot.Lost));
    }

    [Fact]
    public void Frames_missing_between_connections_are_not_lost()
    {
        _tracker.OnFrame(new byte[32], 5, timestamp: 1);
        _tracker.Resume();
        _tracker.OnFrame(new byte[32], 50, timestamp: 2);
        _tracker.OnFrame(new byte[32], 52, timestamp: 3);
        Assert.Equal(1, _tracker.Snapshot.Lost);
    }

    [Fact]
    public void Rate_and_jitter_follow_the_intervals()
    {
        long tick = Stopwatch.Frequency / 100;
        for (int i = 0; i < 1000; i++)
            _tracker.OnFrame(new byte[32], (uint)i, i * tick);

        Assert.Equal(100, _tracker.Snapshot.FrameRate, tolerance: 0.01);
        Assert.Equal(0, _tracker.Snapshot.Jitter.TotalMilliseconds, tolerance: 0.01);

        for (int i = 0; i < 1000; i++)
            _tracker.OnFrame(new byte[32], (uint)(1000 + i), (1000 * tick) + (i * tick) + (i % 2 == 0 ? tick / 5 : 0));

        Assert.Equal(100, _tracker.Snapshot.FrameRate, tolerance: 2);
        Assert.Equal(2, _tracker.Snapshot.Jitter.TotalMilliseconds, tolerance: 0.2);
    }

    [Fact]
    public void Reduced_frequency_is_distinguished_from_loss_across_connections()
    {
        for (uint i = 0; i < 40; i++)
            _tracker.OnFrame(new byte[32], i * 3, timestamp: i);

        Assert.Equal((0, 0, 3), (_tracker.Snapshot.Lost, _tracker.Snapshot.Gaps, _tracker.Snapshot.FrequencyReduction));
        _tracker.Resume();
        _tracker.OnFrame(new byte[32], 7000, timestamp: 50);
        _tracker.OnFrame(new byte[32], 7009, timestamp: 51);
        _tracker.OnFrame(new byte[32], 100_000, timestamp: 52);
        Assert.Equal(
            (2, 1, 3, 1),
            (_tracker.Snapshot.Lost, _tracker.Snapshot.Gaps, _tracker.Snapshot.FrequencyReduction, _tracker.Snapshot.Restarts));
    }

    [Fact]
    public void The_age_is_that_of_the_newest_frame_and_never_negative()
    {
        _tracker.OnFrame(new byte[32], 1, timestamp: Stopwatch.Frequency);
        Assert.Equal(1.5, _tracker.Snapshot.GetAge(Stopwatch.Frequency * 5 / 2).TotalSeconds, tolerance: 1e-6);
        Assert.Equal(TimeSpan.Zero, _tracker.Snapshot.GetAge(0));
    }

    [Fact]
    public void The_newest_name_is_kept()
    {
        _tracker.OnFrame(NameOf("First"), 1, 1);
        _tracker.OnFrame(NameOf("Second"), 2, 2);
        Assert.Equal("Second", _tracker.Snapshot.AvatarName);
        Assert.Equal(2, _tracker.Snapshot.AvatarIndex);
    }

    private static byte[] NameOf(string text)
    {
        byte[] bytes = new byte[32];
        new AvatarName(text).CopyTo(bytes);
        return bytes;
    }
}
