using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

// The test controls the time.
public sealed class StreamCountersTests
{
    private readonly StreamCounters _counters = new();

    [Fact]
    public void Forged_avatars_do_not_displace_a_real_one()
    {
        Flood(first: 5000, count: 1100, seconds: 0);
        for (int i = 0; i < 200; i++)
        {
            if (i % 5 != 2)
                Deliver(frame: i, avatar: 0, seconds: 6 + (i / 60.0));
        }

        AvatarTracker real = Assert.Single(_counters.Trackers, static tracker => tracker.Avatar == 0);
        Assert.Equal((160, 40), (real.Snapshot.Frames, real.Snapshot.Lost));
        Assert.Equal((40, AvatarTrackers.MaxTrackers), (_counters.Snapshot().Lost, _counters.Trackers.Length));
    }

    [Fact]
    public void A_flood_does_not_evict_active_avatars()
    {
        for (int i = 0; i < 600; i++)
        {
            if (i % 5 != 2)
                Deliver(frame: i, avatar: 0, seconds: i / 60.0);

            Flood(first: 5000 + (i * 10), count: 10, seconds: i / 60.0);
        }

        Assert.Equal(120, Assert.Single(_counters.Trackers, static tracker => tracker.Avatar == 0).Snapshot.Lost);
    }

    [Fact]
    public void Totals_keep_the_losses_of_evicted_avatars()
    {
        Deliver(frame: 1, avatar: 0, seconds: 0);
        Deliver(frame: 4, avatar: 0, seconds: 0.1);
        Deliver(frame: 100_000, avatar: 0, seconds: 0.2);
        for (int round = 0; round < 3; round++)
            Flood(first: 5000 * (round + 1), count: 1100, seconds: 10 * (round + 1));

        Assert.DoesNotContain(_counters.Trackers, static tracker => tracker.Avatar == 0);
        ReaderStatistics statistics = _counters.Snapshot();
        Assert.Equal((2, 1, 1), (statistics.Lost, statistics.Gaps, statistics.Restarts));
    }

    [Fact]
    public void Reading_totals_allocates_nothing()
    {
        Deliver(frame: 1, avatar: 0, seconds: 0);
        Deliver(frame: 4, avatar: 1, seconds: 0.1);
        long lost = 0;
        Allocations.AssertNone(() => lost += _counters.Snapshot().Lost);
        Assert.Equal(0, lost);
    }

    // The avatar before it still remembers it as the next in turn.
    [Fact]
    public void An_evicted_avatar_that_returns_is_counted_anew()
    {
        Deliver(frame: 1, avatar: 0, seconds: 0);
        Deliver(frame: 1, avatar: 1, seconds: 0);
        Flood(first: 5000, count: AvatarTrackers.MaxTrackers - 2, seconds: 1);
        Deliver(frame: 2, avatar: 0, seconds: 4);
        Flood(first: 9000, count: 1, seconds: 5.5);
        Assert.DoesNotContain(_counters.Trackers, static tracker => tracker.Avatar == 1);

        Deliver(frame: 3, avatar: 0, seconds: 7);
        Deliver(frame: 20, avatar: 1, seconds: 7);
        Assert.Equal(1, Assert.Single(_counters.Trackers, static tracker => tracker.Avatar == 1).Snapshot.Frames);
    }

    [Fact]
    public void Avatars_beyond_the_limit_allocate_nothing()
    {
        Flood(first: 5000, count: AvatarTrackers.MaxTrackers, seconds: 0);
        ReceivedPacket packet = Packet(frame: 1, avatar: 1, seconds: 1);
        Allocations.AssertNone(() => _counters.Count(packet));
    }

    [Fact]
    public void Every_source_gets_trackers_despite_forged_avatars()
    {
        Flood(first: 5000, count: 2 * AvatarTrackers.MaxTrackers, seconds: 0);
        for (int avatar = 0; avatar < 20; avatar++)
            _counters.Count(Packet(frame: 1, avatar, seconds: 1, source: 1));

        Assert.Equal(AvatarTrackers.MaxTrackers, _counters.Trackers.Count(tracker => tracker.Sender == 0));
        Assert.Equal(AvatarTrackers.TrackersOfSender, _counters.Trackers.Count(tracker => tracker.Sender == 1));
    }

    [Fact]
    public void A_new_sender_of_a_source_continues_its_statistics()
    {
        for (int frame = 100; frame < 130; frame++)
            _counters.Count(Packet(frame, avatar: 0, seconds: frame / 100.0));
        for (int frame = 90; frame < 130; frame++)
            _counters.Count(Packet(frame, avatar: 0, seconds: 3 + (frame / 100.0), run: 1));

        AvatarStatistics avatar = Assert.Single(_counters.Trackers).Snapshot;
        Assert.Equal((70L, 1L, 0L, 0L), (avatar.Frames, avatar.Restarts, avatar.OutOfOrder, avatar.Lost));
    }

    // Datagrams that waited keep their arrival time.
    [Fact]
    public void The_newest_frame_time_never_decreases()
    {
        Deliver(frame: 1, avatar: 0, seconds: 2);
        Deliver(frame: 1, avatar: 1, seconds: 1.5);
        Assert.Equal(2 * Stopwatch.Frequency, _counters.Snapshot().LastFrameTimestamp - 1);
        Assert.True(_counters.Snapshot().Duration >= TimeSpan.Zero);
    }

    [Theory]
    [InlineData(true, true, 0)]
    [InlineData(true, false, 2)]
    [InlineData(false, false, 0)]
    public void Only_the_calculation_connection_excuses_its_gap(bool hasCalculationPort, bool isCalculation, int lost)
    {
        _counters.Resume();
        if (hasCalculationPort)
            _counters.Resume(isCalculation: true);

        for (int frame = 0; frame < 20; frame++)
        {
            if (frame == 10)
                _counters.Resume(isCalculation);
            if (frame is not (10 or 11))
                _counters.Count(new ReceivedPacket(PacketKind.Calculation, TestPackets.Calculation(frame), frame + 1, origin: 0));
        }

        Assert.Equal(lost, _counters.Snapshot().Lost);
    }

    private void Flood(int first, int count, double seconds)
    {
        for (int i = 0; i < count; i++)
            Deliver(frame: 1, first + i, seconds);
    }

    private void Deliver(int frame, int avatar, double seconds) => _counters.Count(Packet(frame, avatar, seconds));

    private static ReceivedPacket Packet(int frame, int avatar, double seconds, int source = 0, int run = 0) =>
        new(PacketKind.Motion, TestPackets.Motion(frame, avatar, count: 6), (long)(seconds * Stopwatch.Frequency) + 1, PacketOrigin.Create(source, run));
}
