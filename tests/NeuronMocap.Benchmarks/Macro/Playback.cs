using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Recording;

namespace NeuronMocap.Benchmarks.Macro;

// How late each frame of a recording reaches a handler after it is due, and the processor time that the process needs.
internal static class Playback
{
    private const double FrameRate = 120;

    public static async Task<int> RunAsync(double[] speeds, double seconds, Report report)
    {
        report.Begin($"One avatar at {FrameRate} Hz, {seconds} s a run: microseconds from when a frame was due to its handler, at all frames but the first second's.");
        string path = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
        try
        {
            foreach (double speed in speeds)
            {
                Write(path, (int)(seconds * speed * FrameRate));
                (double[] errors, double cpu) = await PlayAsync(path, speed);
                foreach ((string figure, double value, double? limit) in ((string, double, double?)[])
                    [
                        ("median µs", Spread.Percentile(errors, 0.5), null),
                        ("p99 µs", Spread.Percentile(errors, 0.99), null),
                        ("most µs", errors[^1], 1000),
                        ("% of a processor", cpu * 100, null),
                    ])
                {
                    report.Add([new Row($"{speed} x", "callback", figure, value, Floor: null, Ratio: null, limit is null ? null : $"at most {limit}", limit is null ? (bool?)null : value <= limit)]);
                }
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

    private static async Task<(double[] Errors, double Cpu)> PlayAsync(string path, double speed)
    {
        using RecordingPlayer player = RecordingPlayer.Open(path);
        player.Speed = speed;
        await using var reader = new NeuronReader(player);
        var errors = new List<double>();
        reader.MotionReceived += frame =>
        {
            double error = (Stopwatch.GetTimestamp() - frame.Timestamp) * 1e6 / Stopwatch.Frequency;
            if (frame.FrameIndex >= FrameRate * speed)
                errors.Add(error);
        };
        using var process = Process.GetCurrentProcess();
        TimeSpan before = process.TotalProcessorTime;
        var watch = Stopwatch.StartNew();
        reader.Start();
        await reader.Completion;
        process.Refresh();
        return ([.. errors.Order()], (process.TotalProcessorTime - before) / watch.Elapsed);
    }
}
