using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Recording;

namespace NeuronMocap.Benchmarks.Macro;

// How late each frame of a recording reaches a handler after it is due, and the processor time that the process needs.
internal static class Playback
{
    private const double FrameRate = 120;
    private const string Most = "most µs";
    private const string Near = "% within 0.2 ms";
    private const string Within = "% within 1 ms";

    private static readonly Aim[] Aims = [new(Near, 99, IsLowerBound: true, Way: "callback"), new(Within, 100, IsLowerBound: true, Way: "callback")];

    // The bare loop sleeps until so long before each instant, as a playback does.
    private static readonly long Spin = Stopwatch.Frequency / 8000;

    public static async Task<int> RunAsync(double[] speeds, double seconds, int runs, Report report)
    {
        report.Begin($"One avatar at {FrameRate} Hz, {seconds} s a run, {runs} runs: how late each frame is at its handler, without the first second's; the floor is a thread that sleeps until each instant. The bare loop sleeps precisely and spins, without a reader.");
        string path = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
        try
        {
            foreach (double speed in speeds)
            {
                int frames = (int)(seconds * speed * FrameRate);
                Write(path, frames);
                Way[] ways = [new("callback", () => PlayAsync(path, speed)), new("bare loop", () => Loop(frames, speed, WaitPrecisely))];
                report.Add(await Alternation.RunAsync($"{speed} x", runs, new Way("sleep", () => Loop(frames, speed, PacedSender.WaitUntil)), ways, Aims));
            }
        }
        finally
        {
            File.Delete(path);
        }

        return report.End();
    }

    private static void Write(string path, int frames)
    {
        using var stream = new FileStream(path, FileMode.Create);
        using var writer = new RecordingWriter(stream);
        byte[] packet = TestFrame.Create();
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
        for (int frame = 0; frame < frames; frame++)
        {
            TestFrame.SetIndex(packet, (uint)frame);
            writer.WriteBytes(TimeSpan.FromSeconds(frame / FrameRate), 0, packet);
        }
    }

    private static async Task<Measurements> PlayAsync(string path, double speed)
    {
        using RecordingPlayer player = RecordingPlayer.Open(path);
        player.Speed = speed;
        await using var reader = new NeuronReader(player);
        var errors = new List<double>();
        reader.MotionReceived += frame =>
        {
            double error = Microseconds(Stopwatch.GetTimestamp() - frame.Timestamp);
            if (frame.FrameIndex >= FrameRate * speed)
                errors.Add(error);
        };
        TimeSpan before = RuntimeFigures.CpuTime;
        var watch = Stopwatch.StartNew();
        reader.Start();
        await reader.Completion;
        return ToFigures(errors, (RuntimeFigures.CpuTime - before) / watch.Elapsed);
    }

    // What a program could do without the library.
    private static Measurements Loop(int frames, double speed, Action<long> waitUntil)
    {
        var errors = new List<double>();
        TimeSpan before = RuntimeFigures.CpuTime;
        long start = Stopwatch.GetTimestamp();
        for (int frame = 0; frame < frames; frame++)
        {
            long due = start + (long)(frame / (FrameRate * speed) * Stopwatch.Frequency);
            waitUntil(due);
            if (frame >= FrameRate * speed)
                errors.Add(Microseconds(Stopwatch.GetTimestamp() - due));
        }

        return ToFigures(errors, (RuntimeFigures.CpuTime - before) / Stopwatch.GetElapsedTime(start));
    }

    // Shows how late the system wakes any thread.
    private static void WaitPrecisely(long due)
    {
        long rest;
        while ((rest = due - Stopwatch.GetTimestamp()) > 0)
        {
            if (PreciseSleep.IsAvailable && rest > Spin)
                PreciseSleep.Sleep(rest - Spin);
        }
    }

    private static double Microseconds(long ticks) => ticks * 1e6 / Stopwatch.Frequency;

    private static Measurements ToFigures(List<double> errors, double share)
    {
        double[] sorted = [.. errors.Order()];
        return new Measurements
        {
            ["median µs"] = Spread.Percentile(sorted, 0.5),
            ["p99 µs"] = Spread.Percentile(sorted, 0.99),
            [Most] = sorted[^1],
            [Near] = Share(200),
            [Within] = Share(1000),
            ["% of a processor"] = share * 100,
        };

        double Share(double limit) => sorted.Count(error => error <= limit) * 100.0 / sorted.Length;
    }
}
