using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Motion;

// The hips move along X at 100 cm/s of the sender's clock, so positions show times: 1 cm is 10 ms.
public sealed class PoseBufferTests
{
    private const double Interval = 0.010;
    private const float Speed = 100;

    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];

    [Fact]
    public void There_is_no_pose_before_the_first_frame()
    {
        _pose[0] = new BoneTransform(Vector3.One, Quaternion.Identity);
        Assert.Equal(PoseOrigin.None, new PoseBuffer().Sample(1, _pose));
        Assert.Equal(Vector3.One, _pose[0].Position);
    }

    [Fact]
    public void The_first_frame_is_held_until_it_is_due()
    {
        PoseBuffer buffer = Create(delay: 30);
        Push(buffer, 0, 1, 0);
        Assert.Equal(PoseOrigin.First, buffer.Sample(1.02, _pose));
        Assert.Equal(0, Place);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Even_frames_give_the_delayed_pose(bool hasIndex)
    {
        PoseBuffer buffer = Create(delay: 25);
        for (int i = 0; i < 500; i++)
        {
            Push(buffer, i, i * Interval, hasIndex ? (uint)i : null);
            if (i < 10)
                continue;

            Assert.Equal(PoseOrigin.Interpolated, buffer.Sample((i * Interval) + 0.003, _pose));
            Assert.Equal(((i * Interval) + 0.003 - 0.025) * Speed, Place, 1e-3);
        }

        Assert.Equal(Interval, buffer.FrameInterval, 1e-6);
        Assert.True(buffer.Jitter < 1e-6);
        Assert.Equal(0, buffer.Dropped);
    }

    [Theory]
    [InlineData(5, 45, 50)]
    [InlineData(25, 0, 0)]
    public void Frames_that_come_after_their_display_time_are_counted(int delay, int least, int most)
    {
        PoseBuffer buffer = Create(delay);
        for (int i = 0; i < 500; i++)
        {
            double lateness = i % 10 == 5 ? 0.008 : 0;
            Push(buffer, i, (i * Interval) + lateness, (uint)i);
            buffer.Sample((i * Interval) + lateness, _pose);
        }

        Assert.InRange(buffer.Late, least, most);
    }

    [Fact]
    public void Motion_is_extrapolated_slows_down_and_stops_without_frames()
    {
        PoseBuffer buffer = Create(delay: 20, extrapolation: 40);
        for (int i = 0; i <= 50; i++)
            Push(buffer, i, i * Interval, (uint)i);

        double newest = 50 * Interval;
        double last = 0;
        double lastStep = double.PositiveInfinity;
        for (int i = 0; i < 100; i++)
        {
            double beyond = i * 0.001;
            PoseOrigin origin = buffer.Sample(newest + 0.020 + beyond, _pose);
            Assert.True(origin == PoseOrigin.Held || beyond < 0.0405, $"{beyond}: {origin}");
            Assert.True(Place >= last - 1e-4 && (i < 2 || Place - last <= lastStep + 1e-4), $"{i}: {Place} after {last}");
            lastStep = i == 0 ? lastStep : Place - last;
            last = Place;
        }

        // Half of 40 ms at the newest speed.
        Assert.Equal((newest + 0.020) * Speed, last, 1e-3);
        Assert.Equal(PoseOrigin.Extrapolated, buffer.Sample(newest + 0.030, _pose));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void An_initial_burst_is_not_extrapolated(bool hasIndex)
    {
        // Three within a millisecond, as a server sends its buffered frames to a new client. The fourth comes a frame later.
        PoseBuffer buffer = Create(delay: 0);
        double[] arrivals = [0, 0.0005, 0.001, 0.010, 0.020, 0.030, 0.040, 0.050, 0.060, 0.070];
        int next = 0;
        for (double time = 0; time < 0.080; time += 0.001)
        {
            for (; next < arrivals.Length && arrivals[next] <= time; next++)
                Push(buffer, next, arrivals[next], hasIndex ? (uint)next : null);

            buffer.Sample(time, _pose);
            Assert.True(Place < next - 1 + 2.5, $"{time}: {Place}, and the newest frame is {next - 1}.");
        }
    }

    [Fact]
    public void Extrapolation_can_be_switched_off()
    {
        PoseBuffer buffer = Create(delay: 0, extrapolation: 0);
        for (int i = 0; i <= 50; i++)
            Push(buffer, i, i * Interval, (uint)i);

        Assert.Equal(PoseOrigin.Held, buffer.Sample(0.6, _pose));
        Assert.Equal(50, Place, 1e-4);
    }

    [Fact]
    public void Late_repeated_and_reordered_frames_are_sorted()
    {
        PoseBuffer buffer = Create(delay: 60);
        var random = new Random(5);
        List<(int Frame, double Arrival)> arrivals = [];
        for (int i = 0; i < 1000; i++)
        {
            if (random.Next(20) == 0)
                continue; // lost

            double arrival = (i * Interval) + (random.Next(10) == 0 ? 0.030 : random.NextDouble() * 0.002);
            arrivals.Add((i, arrival));
            if (random.Next(20) == 0)
                arrivals.Add((i, arrival + 0.001));
        }

        arrivals.Sort((one, other) => one.Arrival.CompareTo(other.Arrival));
        double lowest = double.PositiveInfinity;
        double highest = double.NegativeInfinity;
        foreach ((int frame, double arrival) in arrivals)
        {
            Push(buffer, frame, arrival, (uint)frame);
            PoseOrigin origin = buffer.Sample(arrival, _pose);
            if (arrival < 2)
                continue;

            // Frames are late by 4 ms on average. How much of that the clock attributes to the sender may vary a little.
            Assert.Equal(PoseOrigin.Interpolated, origin);
            double lag = arrival - (Place / Speed);
            lowest = Math.Min(lowest, lag);
            highest = Math.Max(highest, lag);
        }

        Assert.True(highest - lowest < 0.004, $"The lag was {lowest} to {highest} s.");

        // Lost frames make it longer, because it is a mean of the last few.
        Assert.InRange(buffer.FrameInterval, Interval * 0.95, Interval * 1.5);
    }

    [Theory]
    [InlineData(0u, true)] // the server restarts
    [InlineData(4_000_000_000u, true)]
    [InlineData(0u, false)]
    public void A_paused_sender_is_followed_again(uint firstIndex, bool hasIndex)
    {
        PoseBuffer buffer = Create(delay: 30);
        for (int i = 0; i < 200; i++)
            PushAndSample(buffer, i, i * Interval, hasIndex ? 1000 + (uint)i : null);

        double before = Place;
        for (int i = 0; i < 200; i++)
        {
            double arrival = 5 + (i * Interval);
            PushAndSample(buffer, 300 + i, arrival, hasIndex ? unchecked(firstIndex + (uint)i) : null);
            if (i == 0)
                Assert.True(Math.Abs(Place - before) < 10, $"The pose jumped from {before} to {Place}.");
            if (i >= 4)
                Assert.Equal(300 + ((i - 3) * Interval * Speed), Place, 0.3);
        }
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(2, 0)]
    [InlineData(8, 0)]
    [InlineData(8, 1e-7)]
    [InlineData(8, 0.001)]
    public void An_early_restart_of_the_index_does_not_freeze_the_pose(int framesBefore, double intervalBefore)
    {
        PoseBuffer buffer = Create(delay: 30);
        for (int i = 0; i < framesBefore; i++)
            PushAndSample(buffer, 0, i * intervalBefore, 50_000 + (uint)i);

        for (int i = 1; i < 200; i++)
        {
            PushAndSample(buffer, i, i * Interval, (uint)i);
            if (i > 60)
                Assert.Equal((i - 3) * Interval * Speed, Place, 0.3);
        }
    }

    [Fact]
    public void A_wrapping_index_continues()
    {
        PoseBuffer buffer = Create(delay: 30);
        for (int i = 0; i < 200; i++)
        {
            PushAndSample(buffer, i, i * Interval, unchecked(uint.MaxValue - 99 + (uint)i));
            if (i > 10)
                Assert.Equal((i - 3) * Interval * Speed, Place, 1e-2);
        }
    }

    [Fact]
    public void A_constant_index_is_ignored()
    {
        PoseBuffer buffer = Create(delay: 30);
        for (int i = 0; i < 200; i++)
        {
            PushAndSample(buffer, i, i * Interval, 7);
            if (i > 10)
                Assert.Equal((i - 3) * Interval * Speed, Place, 1e-2);
        }
    }

    [Fact]
    public void An_index_in_steps_is_used()
    {
        PoseBuffer buffer = Create(delay: 30);
        for (int i = 0; i < 200; i++)
            PushAndSample(buffer, i, i * Interval, (uint)(i * 4));

        Assert.Equal(196, Place, 1e-2);
        Assert.Equal(Interval, buffer.FrameInterval, 1e-6);
    }

    [Theory]
    [InlineData(0.010, 1 / 60.0)]
    [InlineData(1 / 60.0, 1 / 120.0)]
    [InlineData(1 / 120.0, 1 / 30.0)]
    public void A_new_rate_is_found_within_half_a_second(double first, double second)
    {
        PoseBuffer buffer = Create(delay: 50);
        double time = 0;
        uint index = 0;
        for (; time < 3; time += first)
            PushAndSample(buffer, (float)(time * Speed), time, index++);

        double end = time + 2;
        double change = time;
        for (; time < end; time += second)
        {
            PushAndSample(buffer, (float)(time * Speed), time, index++);
            if (time > change + 0.5)
                Assert.Equal((time - 0.050) * Speed, Place, 0.5);
        }

        Assert.Equal(second, buffer.FrameInterval, second / 50);
    }

    [Fact]
    public void Clock_drift_is_followed()
    {
        // The sender's clock is slower by one in a thousand. Over ten minutes it falls behind by 0.6 s.
        PoseBuffer buffer = Create(delay: 30);
        for (int i = 0; i < 60_000; i++)
        {
            PushAndSample(buffer, i % 1000, i * Interval * 1.001, (uint)i);
            if (i > 300 && i % 1000 > 10)
                Assert.Equal((i % 1000) - 2.997, Place, 0.05);
        }
    }

    [Fact]
    public void Full_queue_drops_and_counts_then_recovers()
    {
        var buffer = new PoseBuffer(new PoseBufferOptions { Capacity = 8 });
        for (int i = 0; i < 20; i++)
            Assert.Equal(i < 8, Push(buffer, i, i * Interval, (uint)i));

        Assert.Equal(12, buffer.Dropped);
        buffer.Sample(20 * Interval, _pose);
        Assert.True(Push(buffer, 20, 20 * Interval, 20));
        buffer.Sample(25 * Interval, _pose);
        Assert.InRange(Place, 19, 23);
        Assert.False(Push(buffer, 21, double.NaN, 21));
        Assert.Equal(13, buffer.Dropped);
    }

    [Fact]
    public void Times_may_go_back_as_far_as_the_buffer()
    {
        PoseBuffer buffer = Create(delay: 30);
        for (int i = 0; i < 50; i++)
            Push(buffer, i, i * Interval, (uint)i);

        buffer.Sample(0.400, _pose);
        Assert.Equal(37, Place, 1e-2);
        buffer.Sample(0.395, _pose);
        Assert.Equal(36.5, Place, 1e-2);
        Assert.Equal(PoseOrigin.First, buffer.Sample(0.100, _pose));
    }

    [Fact]
    public void Nothing_is_allocated()
    {
        PoseBuffer buffer = Create(delay: 30);
        int frame = 0;
        Allocations.AssertNone(() =>
        {
            PushAndSample(buffer, frame, frame * Interval, (uint)frame);
            frame++;
        });
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => Create(delay: -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Create(delay: 1, extrapolation: -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new PoseBuffer(new PoseBufferOptions { Capacity = 7 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => new PoseBuffer(new PoseBufferOptions { Capacity = 4097 }));
        Assert.Throws<ArgumentException>(() => new PoseBuffer().Push(new BoneTransform[58], 0));
        Assert.Throws<ArgumentException>(() => new PoseBuffer().Sample(0, new BoneTransform[58]));
    }

    private double Place => _pose[0].Position.X;

    private static PoseBuffer Create(double delay, double extrapolation = 50) => new(new PoseBufferOptions
    {
        Delay = TimeSpan.FromMilliseconds(delay),
        MaxExtrapolation = TimeSpan.FromMilliseconds(extrapolation),
    });

    private static bool Push(PoseBuffer buffer, float place, double arrival, uint? index)
    {
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        pose.Fill(new BoneTransform(new Vector3(place, 0, 0), Quaternion.Identity));
        return buffer.Push(pose, arrival, index);
    }

    private void PushAndSample(PoseBuffer buffer, float place, double arrival, uint? index)
    {
        Push(buffer, place, arrival, index);
        buffer.Sample(arrival, _pose);
    }
}
