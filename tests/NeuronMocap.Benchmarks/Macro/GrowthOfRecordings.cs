using System.Diagnostics;
using System.Text.Json;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Benchmarks.Macro;

// Recordings of some hours: opening, moving to an instant and reading the first frame after it, reading all entries, and the program's command info.
internal static class GrowthOfRecordings
{
    public const string Case = "recordings";
    private const double FrameRate = 60;
    private const int Opens = 20;
    private const int Jumps = 200;

    // tool: the program whose command info is measured. Null to leave it out.
    public static async Task RunAsync(double[] hours, FileInfo? tool, int runs, Report report)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("growth");
        try
        {
            byte[][] walk = Walk();
            List<Way> ways = [];
            foreach (double length in hours.Order())
            {
                string path = Path.Combine(folder.FullName, $"{Peer.Text(length)}.nmrec");
                long frames = (long)(length * 3600 * FrameRate);
                Write(path, walk, frames);
                ways.Add(new Way($"{Peer.Text(length)} h", () => MeasureAsync(path, frames, tool)));
            }

            report.Add(await Alternation.RunAsync(Case, runs, ways[0], ways[1..], []));
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    // A lap of a walk, because its values compress as those of a suit do. Zeros nearly vanish.
    private static byte[][] Walk()
    {
        var source = new SyntheticSource(FrameRate);
        float[] values = new float[(TestFrame.Size - TestFrame.HeaderSize) / sizeof(float)];
        byte[][] frames = new byte[(int)(40 * FrameRate)][];
        for (int i = 0; i < frames.Length; i++)
        {
            source.WriteValues(i, new ChannelLayout(hasDisplacement: true, hasReference: false), RotationOrder.YXZ, values);
            PacketEncoder.WriteMotion(frames[i] = new byte[TestFrame.Size], new MotionHeader { HasDisplacement = true, AvatarName = new AvatarName("Char00") }, values);
        }

        return frames;
    }

    // Compressed, so that the file of ten hours stays in memory and the disk is not measured.
    private static void Write(string path, byte[][] walk, long frames)
    {
        using var writer = RecordingWriter.Create(path, options: new RecordingWriterOptions { Compress = true });
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
        for (long frame = 0; frame < frames; frame++)
        {
            byte[] packet = walk[frame % walk.Length];
            TestFrame.SetIndex(packet, (uint)frame);
            writer.WriteBytes(TimeSpan.FromSeconds(frame / FrameRate), 0, packet);
        }
    }

    private static async Task<Measurements> MeasureAsync(string path, long frames, FileInfo? tool)
    {
        double open = MillisecondsOf(Opens, () => RecordingReader.Open(path).Dispose());

        using RecordingReader reader = RecordingReader.Open(path);
        var random = new Random(1);
        double seek = MillisecondsOf(Jumps, () =>
        {
            TimeSpan position = random.NextDouble() * reader.Duration;
            reader.Seek(position);

            // Descriptions of the connections come first.
            while (reader.TryRead(out RecordingEntry entry))
            {
                if (entry.Kind == RecordingEntryKind.Bytes && entry.Time >= position)
                    return;
            }

            throw new InvalidOperationException("There is no frame after this instant.");
        });

        reader.Seek(TimeSpan.Zero);
        long entries = 0;
        double read = MillisecondsOf(1, () =>
        {
            while (reader.TryRead(out _))
                entries++;
        });
        if (entries < frames)
            throw new InvalidOperationException("Not every entry was read.");

        var figures = new Measurements { ["open, µs"] = open * 1000, ["seek, µs"] = seek * 1000, ["read all, ms"] = read };
        if (tool is not null)
            figures["info, ms"] = await InfoAsync(tool, path, frames);

        return figures;
    }

    private static double MillisecondsOf(int times, Action call)
    {
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < times; i++)
            call();

        return Stopwatch.GetElapsedTime(start).TotalMilliseconds / times;
    }

    private static async Task<double> InfoAsync(FileInfo tool, string path, long frames)
    {
        long start = Stopwatch.GetTimestamp();
        using Process process = Process.Start(new ProcessStartInfo("dotnet", ["exec", tool.FullName, "info", "--json", path]) { RedirectStandardOutput = true, UseShellExecute = false })!;
        string printed = await process.StandardOutput.ReadToEndAsync();
        await process.WaitForExitAsync();
        double elapsed = Stopwatch.GetElapsedTime(start).TotalMilliseconds;
        if (process.ExitCode != 0 || JsonDocument.Parse(printed).RootElement.GetProperty("stream").GetProperty("motionFrames").GetInt64() != frames)
            throw new InvalidOperationException($"info did not count {frames} frames:\n{printed}");

        return elapsed;
    }
}
