using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

/// <summary>Which frames a consumer gets that asked for fewer.</summary>
public sealed class FrameThinnerTests
{
    [Theory]
    [InlineData(120, 60, 2)]
    [InlineData(120, 30, 4)]
    [InlineData(120, 40, 3)]
    [InlineData(60, 60, 1)]
    [InlineData(60, 120, 1)]
    [InlineData(120.3, 60, 2)]
    [InlineData(59.94, 30, 2)]
    [InlineData(120, 12, 10)]
    public void A_whole_fraction_takes_every_nth_frame(double streamRate, double maxRate, int every)
    {
        List<int> taken = Take(Thin(maxRate), 2000, frame => frame / streamRate);
        Assert.Equal(Enumerable.Range(0, taken.Count).Select(i => i * every), taken);
        Assert.Equal((2000 + every - 1) / every, taken.Count);
    }

    // A network delays each frame by up to 7 ms. The first intervals then look like those of a rate from 42 to 103 Hz.
    [Theory]
    [InlineData(60)]
    [InlineData(60.5)]
    [InlineData(59.94)]
    public void A_stream_of_the_wanted_rate_keeps_every_frame_from_the_first_on(double streamRate)
    {
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            FrameThinner thinner = Thin(60);
            Take(thinner, 1000, frame => (frame / streamRate) + (random.NextDouble() * 0.007));
            Assert.Equal(0, thinner.Skipped);
        }
    }

    // With 125 Hz at most 60 Hz, two frames are 2 or 3 frames apart, and any ten steps together differ by one at most.
    [Theory]
    [InlineData(125, 60)]
    [InlineData(120, 50)]
    [InlineData(100, 60)]
    [InlineData(120, 100)]
    public void Other_ratios_are_as_even_as_possible(double streamRate, double maxRate)
    {
        const int Frames = 5000;
        List<int> taken = Take(Thin(maxRate), Frames, frame => frame / streamRate);
        Assert.InRange(taken.Count, (Frames * maxRate / streamRate) - 1, (Frames * maxRate / streamRate) + 1);
        foreach (int span in (int[])[1, 10, 100])
        {
            double expected = span * streamRate / maxRate;
            for (int i = 0; i + span < taken.Count; i++)
                Assert.InRange(taken[i + span] - taken[i], Math.Floor(expected - 1e-9), Math.Ceiling(expected + 1e-9));
        }
    }

    [Theory]
    [InlineData(0.003)]
    [InlineData(0.008)]
    [InlineData(0.02)]
    public void Jitter_of_the_arrival_does_not_beat(double jitter)
    {
        var random = new Random(1);
        AssertSettlesToEverySecond(frame => (frame / 120.0) + (random.NextDouble() * jitter));
    }

    [Theory]
    [InlineData(2)]
    [InlineData(5)]
    [InlineData(10)]
    public void Frames_that_arrive_in_bursts_are_thinned_evenly(int burst) => AssertSettlesToEverySecond(frame => frame / burst * burst / 120.0);

    [Fact]
    public void Every_nth_counts_the_frames_that_arrive()
    {
        FrameThinner thinner = new FrameThinning(0, 3).CreateThinner()!;
        Assert.Equal([0, 6, 12, 18], Take(thinner, 12, _ => 0, indexStep: 2));
        Assert.Equal(8, thinner.Skipped);
    }

    // The server's frequency reduction: the index steps by 2 at 60 Hz.
    [Fact]
    public void A_reduced_stream_is_thinned_by_its_own_rate()
    {
        List<int> taken = Take(Thin(30), 400, frame => frame / 120.0, indexStep: 2);
        Assert.Equal(Enumerable.Range(0, 200).Select(static i => 4 * i), taken);
    }

    [Fact]
    public void A_lost_frame_does_not_shift_the_others()
    {
        FrameThinner thinner = Thin(60);
        List<int> taken = [];
        for (int frame = 0; frame < 100; frame++)
        {
            if (frame is not (30 or 31 or 51) && Takes(thinner, PacketKind.Motion, frame, frame / 120.0))
                taken.Add(frame);
        }

        Assert.Equal([.. Enumerable.Range(0, 15).Select(static i => 2 * i), .. Enumerable.Range(16, 34).Select(static i => 2 * i)], taken);
    }

    [Fact]
    public void After_a_pause_the_first_frame_is_taken_and_the_rate_is_kept()
    {
        FrameThinner thinner = Thin(60);
        Take(thinner, 101, frame => frame / 120.0);
        List<int> taken = Take(thinner, 100, frame => 10 + (frame / 120.0), first: 500);
        Assert.Equal(Enumerable.Range(0, 50).Select(static i => 500 + (2 * i)), taken);
    }

    [Fact]
    public void A_stream_slower_than_a_frame_a_second_follows_the_time()
    {
        Assert.Equal([0, 5, 10, 15], Take(Thin(0.1), 20, static frame => frame * 2.0));
        Assert.Equal(20, Take(Thin(1), 20, static frame => frame * 2.0).Count);
    }

    [Fact]
    public void Avatars_and_senders_are_thinned_independently()
    {
        FrameThinner thinner = new FrameThinning(0, 2).CreateThinner()!;
        for (int avatar = 0; avatar < 3; avatar++)
        {
            Assert.True(Takes(thinner, PacketKind.Motion, 1, 0, avatar));
            Assert.True(Takes(thinner, PacketKind.Motion, 1, 0, avatar, origin: PacketOrigin.Create(1, 0)));
        }

        for (int avatar = 0; avatar < 3; avatar++)
            Assert.False(Takes(thinner, PacketKind.Motion, 2, 0, avatar));
    }

    // Either kind can come first, and frames of either kind can be lost.
    [Theory]
    [InlineData(60, 1)]
    [InlineData(50, 1)]
    [InlineData(0, 3)]
    public void Motion_and_calculation_of_one_index_have_the_same_fate(double maxRate, int everyNth)
    {
        FrameThinner thinner = new FrameThinning(maxRate, everyNth).CreateThinner()!;
        var random = new Random(3);
        for (int frame = 0; frame < 2000; frame++)
        {
            double time = (frame / 120.0) + (random.NextDouble() * 0.004);
            PacketKind first = random.Next(2) == 0 ? PacketKind.Motion : PacketKind.Calculation;
            int lost = random.Next(20);
            bool? verdict = lost == 0 ? null : Takes(thinner, first, frame, time);
            bool? other = lost == 1 ? null : Takes(thinner, first == PacketKind.Motion ? PacketKind.Calculation : PacketKind.Motion, frame, time);
            if (verdict is not null && other is not null)
                Assert.Equal(verdict, other);
        }
    }

    // Motion of odd indices is taken; calculation data has even indices only.
    [Fact]
    public void A_kind_whose_indices_are_never_due_is_thinned_alone()
    {
        FrameThinner thinner = new FrameThinning(0, 2).CreateThinner()!;
        int calculations = 0;
        for (int frame = 1; frame < 400; frame++)
        {
            Takes(thinner, PacketKind.Motion, frame, frame / 120.0);
            if (frame % 2 == 0 && Takes(thinner, PacketKind.Calculation, frame, frame / 120.0))
                calculations++;
        }

        Assert.InRange(calculations, 90, 199);
    }

    [Fact]
    public void A_restarted_repeated_or_absent_index_is_thinned_like_any_other()
    {
        FrameThinner thinner = new FrameThinning(0, 2).CreateThinner()!;
        Assert.Equal(50, Take(thinner, 100, _ => 0, first: 1_000_000).Count);
        Assert.Equal(50, Take(thinner, 100, _ => 0).Count);
        Assert.Equal(50, Take(thinner, 100, _ => 0, first: 7, indexStep: 0).Count);
        Assert.Equal(50, Enumerable.Range(0, 100).Count(frame => Takes(thinner, TestPackets.Motion(frame, layout: HeaderLayout.Old), PacketKind.Motion, 0)));
    }

    [Fact]
    public void A_late_frame_gets_the_verdict_of_its_time_or_none()
    {
        FrameThinner thinner = new FrameThinning(0, 2).CreateThinner()!;
        bool[] verdicts = [.. ((int[])[0, 1, 3, 2, 4, 5, 6]).Select(frame => Takes(thinner, PacketKind.Motion, frame, 0))];
        Assert.Equal([true, false, true, false, false, true, false], verdicts);
    }

    [Fact]
    public void Invented_avatars_take_bounded_memory_and_time()
    {
        FrameThinner thinner = new FrameThinning(0, 2).CreateThinner()!;
        byte[] packet = TestPackets.Motion(1, count: 180);
        for (int avatar = 0; avatar < 5000; avatar++)
        {
            BitConverter.TryWriteBytes(packet.AsSpan(10), avatar);
            Takes(thinner, packet, PacketKind.Motion, 0);
        }

        Assert.True(Takes(thinner, PacketKind.Motion, 1, 0, avatar: 6000));
        Assert.False(Takes(thinner, PacketKind.Motion, 2, 0, avatar: 6000));
    }

    // The rate of the stream is known after some frames; from then on every second frame is taken without exception.
    private static void AssertSettlesToEverySecond(Func<int, double> arrival)
    {
        const int Settling = 600;
        List<int> taken = [.. Take(Thin(60), 6000, arrival).Where(static frame => frame >= Settling)];
        Assert.Equal(Enumerable.Range(0, (6000 - Settling) / 2).Select(i => taken[0] + (2 * i)), taken);
    }

    private static FrameThinner Thin(double maxRate) => new FrameThinning(maxRate, 1).CreateThinner()!;

    private static List<int> Take(FrameThinner thinner, int count, Func<int, double> arrival, int first = 0, int indexStep = 1)
    {
        List<int> taken = [];
        for (int i = 0; i < count; i++)
        {
            int frame = first + (i * indexStep);
            if (Takes(thinner, PacketKind.Motion, frame, arrival(i * Math.Max(indexStep, 1))))
                taken.Add(frame);
        }

        return taken;
    }

    private static bool Takes(FrameThinner thinner, PacketKind kind, int frame, double time, int avatar = 0, int origin = 0) => Takes(
        thinner,
        kind == PacketKind.Motion ? TestPackets.Motion(frame, avatar, count: 1) : TestPackets.Calculation(frame, avatar, count: 1),
        kind,
        time,
        origin);

    private static bool Takes(FrameThinner thinner, byte[] packet, PacketKind kind, double time, int origin = 0) =>
        thinner.Takes(new ReceivedPacket(kind, packet, (long)(time * Stopwatch.Frequency), origin));
}
