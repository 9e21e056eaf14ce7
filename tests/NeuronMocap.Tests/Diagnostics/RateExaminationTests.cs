using System.Diagnostics;
using NeuronMocap.Diagnostics;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Diagnostics;

// Frames with arrival times set by the test, so that no clock matters.
public sealed class RateExaminationTests
{
    [Theory]
    [InlineData(60)]
    [InlineData(96)]
    [InlineData(120)]
    public void Usual_rates_pass(int rate)
    {
        Conclusion conclusion = Judge(Frames(100, rate));
        Assert.Equal([DiagnosisVerdict.Receiving], Verdicts(conclusion));
        Assert.Contains($"{rate}.0 frames per second", conclusion.Verdicts[0].Text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(30, 1, "one frame in 2 of 60")]
    [InlineData(48, 1, "one frame in 2 of 96")]
    [InlineData(20, 3, "the server sends one frame in 3")]
    [InlineData(13, 1, "60, 96 or 120")]
    public void A_low_rate_names_frequency_reducing(int rate, int step, string said)
    {
        Conclusion conclusion = Judge(Frames(100, rate, step));
        Assert.Equal([DiagnosisVerdict.LowRate], Verdicts(conclusion));
        Assert.Contains(said, conclusion.Verdicts[0].Text, StringComparison.Ordinal);
        Assert.Contains("Frequency reducing", conclusion.Verdicts[0].Advice, StringComparison.Ordinal);
    }

    [Fact]
    public void A_burst_at_the_start_does_not_count()
    {
        var frames = Frames(10, 1_000_000).Concat(Frames(100, 60).Select(static frame => (frame.Index + 10, frame.Time)));
        Assert.Equal([DiagnosisVerdict.Receiving], Verdicts(Judge(frames)));
    }

    [Theory]
    [InlineData(TransportKind.Udp, "choose TCP")]
    [InlineData(TransportKind.Tcp, "TCP itself loses nothing")]
    public void Gaps_in_the_frame_index_are_lost_frames(TransportKind transport, string said)
    {
        Conclusion conclusion = Judge(Frames(1000, 120).Where(static frame => frame.Index % 10 != 5), transport);
        Assert.Equal([DiagnosisVerdict.LosingFrames], Verdicts(conclusion));
        Assert.Contains("100 of 1000 frames", conclusion.Verdicts[0].Text, StringComparison.Ordinal);
        Assert.Contains(said, conclusion.Verdicts[0].Advice, StringComparison.Ordinal);
    }

    // The statistics that the reader provides.
    [Fact]
    public void Losses_in_a_looping_take_are_found()
    {
        IEnumerable<(long Index, double Time)> sent = Enumerable.Range(0, 200).Select(static i => ((long)i % 100, i / 60.0));
        Conclusion conclusion = Judge(sent.Where(static frame => frame.Index % 5 != 2));
        Assert.Contains(DiagnosisVerdict.LosingFrames, Verdicts(conclusion));
        Assert.Contains(conclusion.Verdicts, static verdict => verdict.Text.Contains("40 of 200 frames", StringComparison.Ordinal));
    }

    [Fact]
    public void Reordering_and_wrapping_are_no_loss()
    {
        uint[] order = [uint.MaxValue - 3, uint.MaxValue - 1, uint.MaxValue - 2, uint.MaxValue, 0, 1, 3, 2, 4, 5];
        Conclusion conclusion = Judge(order.Select(static (index, i) => ((long)index, i / 60.0)));
        Assert.Equal([DiagnosisVerdict.Receiving], Verdicts(conclusion));
    }

    [Fact]
    public void A_repeated_pose_is_reported_as_still()
    {
        var sample = new StreamSample(PacketKind.Motion);
        byte[] packet = TestPackets.Motion(1);
        for (int i = 0; i < 50; i++)
        {
            packet[46] = (byte)i; // the index advances, the values do not
            Deliver(sample, packet, i / 60.0);
        }

        Assert.Equal([DiagnosisVerdict.Motionless], Verdicts(Judge(sample, TransportKind.Tcp)));
    }

    [Fact]
    public void A_repeated_index_is_reported_as_still()
    {
        var sample = new StreamSample(PacketKind.Motion);
        for (int i = 0; i < 50; i++)
        {
            byte[] packet = TestPackets.Motion(i);
            packet[46] = 7;
            Deliver(sample, packet, i / 60.0);
        }

        Assert.Equal([DiagnosisVerdict.Motionless], Verdicts(Judge(sample, TransportKind.Tcp)));
    }

    [Fact]
    public void Too_few_frames_are_reported()
    {
        Conclusion conclusion = Judge(Frames(2, 60));
        Assert.Equal([DiagnosisVerdict.LowRate], Verdicts(conclusion));
        Assert.Contains("Only 2 frames", conclusion.Verdicts[0].Text, StringComparison.Ordinal);
    }

    [Fact]
    public void An_unknown_value_count_is_reported()
    {
        var sample = new StreamSample(PacketKind.Motion);
        for (int i = 0; i < 50; i++)
            Deliver(sample, TestPackets.Motion(i, count: 126), i / 60.0);

        Conclusion conclusion = Judge(sample, TransportKind.Tcp);
        Assert.Equal([DiagnosisVerdict.UnusualValueCount], Verdicts(conclusion));
        Assert.Contains("126 values", conclusion.Verdicts[0].Text, StringComparison.Ordinal);
    }

    [Fact]
    public void Findings_are_sorted_by_severity()
    {
        var sample = new StreamSample(PacketKind.Motion);
        for (int i = 0; i < 50; i++)
            Deliver(sample, TestPackets.Motion(1, layout: HeaderLayout.Old), i / 20.0);

        Assert.Equal(
            [DiagnosisVerdict.Motionless, DiagnosisVerdict.LowRate, DiagnosisVerdict.OldHeader], Verdicts(Judge(sample, TransportKind.Tcp)));
    }

    private static IEnumerable<(long Index, double Time)> Frames(int count, double rate, int step = 1) =>
        Enumerable.Range(0, count).Select(i => ((long)i * step, i / rate));

    private static Conclusion Judge(IEnumerable<(long Index, double Time)> frames, TransportKind transport = TransportKind.Tcp)
    {
        var sample = new StreamSample(PacketKind.Motion);
        foreach ((long index, double time) in frames)
            Deliver(sample, TestPackets.Motion((int)index), time);

        return Judge(sample, transport);
    }

    private static Conclusion Judge(StreamSample sample, TransportKind transport)
    {
        var task = new DiagnosisContext(new LinkOptions("studio", 7001), new DiagnosisOptions(), new StepLog(progress: null), CancellationToken.None);
        return StreamExamination.Judge(task, sample, new StreamEndpoint(transport, "studio", 7001));
    }

    private static void Deliver(StreamSample sample, byte[] packet, double time) =>
        sample.OnPacket(new ReceivedPacket(PacketKind.Motion, packet, (long)(time * Stopwatch.Frequency) + 1, origin: 0));

    private static IEnumerable<DiagnosisVerdict> Verdicts(Conclusion conclusion) => conclusion.Verdicts.Select(static verdict => verdict.Verdict);
}
