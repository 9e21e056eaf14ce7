using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

/// <summary>Motion and calculation frames of one index, where UDP loses, swaps and delays them.</summary>
public sealed class ThinnedPairTests
{
    private FrameThinner _thinner = new FrameThinning(0, 2).CreateThinner()!;

    // Five minutes each. Calculation data is lost more often, because its datagrams are larger.
    [Theory]
    [InlineData(60, 1, 0.05)]
    [InlineData(50, 1, 0.05)]
    [InlineData(30, 1, 0.1)]
    [InlineData(60, 1, 0.3)]
    [InlineData(0, 3, 0.05)]
    public void Losses_do_not_separate_the_kinds(double maxRate, int everyNth, double loss)
    {
        _thinner = new FrameThinning(maxRate, everyNth).CreateThinner()!;
        var random = new Random(7);
        int taken = 0;
        for (int frame = 0; frame < 36_000; frame++)
        {
            bool? motion = random.NextDouble() < loss / 3 ? null : Takes(PacketKind.Motion, frame);
            bool? calculation = random.NextDouble() < loss ? null : Takes(PacketKind.Calculation, frame);
            if (motion is not null && calculation is not null)
                Assert.Equal(motion, calculation);

            taken += motion is true || calculation is true ? 1 : 0;
        }

        double expected = 36_000 * (everyNth > 1 ? 1.0 / everyNth : maxRate / 120);
        Assert.InRange(taken, 0.8 * expected, expected + 1);
    }

    // The network swaps neighbours, within a kind and between the kinds.
    [Theory]
    [InlineData(60, 1)]
    [InlineData(0, 3)]
    public void A_late_frame_has_the_fate_of_its_partner(double maxRate, int everyNth)
    {
        _thinner = new FrameThinning(maxRate, everyNth).CreateThinner()!;
        var random = new Random(7);
        var motion = new bool?[12_000];
        var calculation = new bool?[12_000];
        foreach ((bool isMotion, int frame) in Enumerable.Range(0, 24_000)
            .Select(static i => (IsMotion: i % 2 == 0, Frame: i / 2))
            .OrderBy(each => each.Frame + (random.Next(10) == 0 ? random.NextDouble() * 3 : 0)))
        {
            (isMotion ? motion : calculation)[frame] = Takes(isMotion ? PacketKind.Motion : PacketKind.Calculation, frame);
        }

        Assert.Equal(motion, calculation);
        Assert.InRange(motion.Count(static taken => taken is true), 3000, 6100);
    }

    // Motion of odd indices is taken, and calculation data has even indices only, until the server sends all.
    [Fact]
    public void A_kind_alone_follows_again_as_soon_as_it_shares_an_index()
    {
        int alone = 0;
        for (int frame = 1; frame < 400; frame++)
        {
            Takes(PacketKind.Motion, frame);
            if (frame % 2 == 0 && Takes(PacketKind.Calculation, frame))
                alone++;
        }

        Assert.InRange(alone, 90, 199);
        int differences = 0;
        for (int frame = 400; frame < 1000; frame++)
            differences += Takes(PacketKind.Motion, frame) != Takes(PacketKind.Calculation, frame) ? 1 : 0;

        Assert.InRange(differences, 0, 1);
    }

    // The server halves the rate of calculation data while it runs.
    [Fact]
    public void A_kind_that_no_longer_shares_an_index_gets_its_own_frames()
    {
        for (int frame = 1; frame < 400; frame++)
            Assert.Equal(Takes(PacketKind.Motion, frame), Takes(PacketKind.Calculation, frame));

        int alone = 0;
        for (int frame = 400; frame < 1000; frame++)
        {
            bool isTaken = Takes(PacketKind.Motion, frame);
            Assert.Equal(frame % 2 == 1, isTaken);
            if (frame % 2 == 0 && Takes(PacketKind.Calculation, frame))
                alone++;
        }

        Assert.InRange(alone, 100, 299);
    }

    private bool Takes(PacketKind kind, int frame)
    {
        byte[] packet = kind == PacketKind.Motion ? TestPackets.Motion(frame, count: 1) : TestPackets.Calculation(frame, count: 1);
        return _thinner.Takes(new ReceivedPacket(kind, packet, (long)(frame / 120.0 * Stopwatch.Frequency), 0));
    }
}
