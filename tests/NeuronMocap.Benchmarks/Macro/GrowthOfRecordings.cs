using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Recording;

namespace NeuronMocap.Benchmarks.Macro;

// Recordings of some hours: opening, moving to an instant and reading its first entry, and reading all, as info does.
internal static class GrowthOfRecordings
{
    private const double FrameRate = 60;
    private const int Jumps = 20;

    public static async Task RunAsync(double[] hours, int runs, Report report)
    {
        string[] paths = [.. hours.Select(static _ => Path.Combine(Path.GetTempPath(), Path.GetRandomFileName()))];
        try
        {
            Way[] ways = [.. hours.Select((length, i) => new Way($"{Peer.Text(length)} h", () => Measure(paths[i], length)))];
            for (int i = 0; i < hours.Length; i++)
                Write(paths[i], (long)(hours[i] * 3600 * FrameRate));

            report.Add(await Alternation.RunAsync("recordings", runs, ways[0], ways[1..], []));
        }
        finally
        {
            foreach (string path in paths)
                File.Delete(path);
        }
    }

    // Compressed, because the disk is not measured.
    private static void Write(string path, long frames)
    {
        using var writer = RecordingWriter.Create(path, options: new RecordingWriterOptions { Compress = true });
        byte[] packet = TestFrame.Create();
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
        for (long frame = 0; frame < frames; frame++)
        {
            TestFrame.SetIndex(packet, (uint)frame);
            writer.WriteBytes(TimeSpan.FromSeconds(frame / FrameRate), 0, packet);
        }
    }

    private static Measurements Measure(string path, double hours)
    {
        long start = Stopwatch.GetTimestamp();
        using RecordingReader reader = RecordingReader.Open(path);
        double open = Stopwatch.GetElapsedTime(start).TotalMilliseconds;

        var random = new Random(1);
        start = Stopwatch.GetTimestamp();
        for (int i = 0; i < Jumps; i++)
        {
            reader.Seek(random.NextDouble() * reader.Duration);
            if (!reader.TryRead(out _))
                throw new InvalidOperationException("There is no entry at this instant.");
        }

        double seek = Stopwatch.GetElapsedTime(start).TotalMilliseconds / Jumps;

        reader.Seek(TimeSpan.Zero);
        long entries = 0;
        TimeSpan cpu = RuntimeFigures.CpuTime;
        while (reader.TryRead(out _))
            entries++;

        cpu = RuntimeFigures.CpuTime - cpu;
        if (entries < (long)(hours * 3600 * FrameRate))
            throw new InvalidOperationException("Not every entry was read.");

        return new Measurements { ["open, ms"] = open, ["seek, ms"] = seek, ["read all, CPU ns/frame"] = cpu.TotalNanoseconds / entries };
    }
}
