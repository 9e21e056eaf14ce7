using System.Diagnostics;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

// Spreading packets must never reduce the rate. No real time passes: waits end late, as on busy systems, and everything else takes no time.
public sealed class FramePacerTests
{
    private const int Frames = 1000;

    // As many packets as are sent one by one, more packets than that, and as many as there are milliseconds.
    public static MatrixTheoryData<(double Rate, int Packets), (int Least, int Most)> Cases { get; } = new(
        [(30, 16), (60, 8), (60, 9), (60, 12), (60, 16), (120, 1), (120, 4), (120, 5), (120, 8), (125, 4), (125, 8), (500, 1), (1000, 1)],
        [(0, 0), (1, 1), (1, 2), (2, 2), (0, 16)]);

    [Theory, MemberData(nameof(Cases))]
    public void The_rate_is_kept_however_late_waits_end((double Rate, int Packets) limit, (int Least, int Most) late)
    {
        var time = new LateTime(late.Least, late.Most);
        BroadcasterOptions options = Expect.Options(limit.Packets, Frames);
        options.FrameRate = limit.Rate;
        var plan = new FramePlan(options, [.. options.Sources.Select(static _ => new AvatarName("a"))], limit.Rate, hasMotion: true, hasCalculation: false);
        using var ended = new ManualResetEventSlim();
        Exception? failure = null;
        var pacer = new FramePacer(
            [(plan, new FrameLog(4, limit.Packets))],
            limit.Rate,
            error =>
            {
                failure = error;
                ended.Set();
            },
            new FaultReport("test"),
            time);
        pacer.Worker.Start();
        ended.Wait(TestContext.Current.CancellationToken);

        Assert.Null(failure);
        double last = (Frames - 1) / limit.Rate;
        double spread = Math.Max(1 / limit.Rate, 0.002 * limit.Packets);
        Assert.InRange(time.Seconds, last, last + spread + ((late.Most + 1) / 1000.0));
    }

    // Waits end late by a random time.
    private sealed class LateTime(int least, int most) : PacerTime
    {
        private readonly Random _random = new(1);
        private long _now = Stopwatch.Frequency;

        public override long Now => _now;

        public double Seconds => (_now / (double)Stopwatch.Frequency) - 1;

        public override void Wait(object gate, int milliseconds)
        {
            double late = least + ((most - least) * _random.NextDouble());
            _now += (long)((milliseconds + late) * Stopwatch.Frequency / 1000);
        }
    }
}
