using System.Diagnostics;
using System.Globalization;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Benchmarks.Macro;

// Reads a file as Axis Neuron writes it, 100 MB by default, on one thread. The floor also reads it and looks at every byte.
internal static class BvhFiles
{
    private const int PieceSize = 1 << 17;
    private const double Megabyte = 1e6;

    public static async Task<int> RunAsync(int megabytes, int runs, Report report)
    {
        string path = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".bvh");
        try
        {
            int rows = Write(path, megabytes * (long)Megabyte);
            report.Begin($"Megabytes a second of a file of {megabytes} MB, {rows} rows of {new ChannelLayout(true, false).ValueCount} values, against reading and adding up its bytes; {runs} runs.");
            Way[] ways =
            [
                new("rows", () => Measure(path, rows, ReadRows)),
                new("document", () => Measure(path, rows, static path => BvhDocument.Load(path).FrameCount)),
                new("written", () => MeasureWriting(path)),
            ];
            Aim[] aims =
            [
                new("MB/s", 200, IsLowerBound: true, Way: "rows"),
                new("MB/s", 200, IsLowerBound: true, Way: "document"),
                new("B/row", 1, Way: "rows"),
                new("B/row", 1, Way: "written"),
                new("B/row", 1.05 * sizeof(float) * 354, Way: "document"),
            ];
            report.Add(await Alternation.RunAsync("one file", runs, new Way("bytes", () => Measure(path, rows, AddBytes)), ways, aims));
            return report.End();
        }
        finally
        {
            File.Delete(path);
        }
    }

    private static Measurements Measure(string path, int rows, Func<string, long> read)
    {
        long allocated = GC.GetAllocatedBytesForCurrentThread();
        long start = Stopwatch.GetTimestamp();
        long result = read(path);
        double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
        if (result != rows)
            throw new InvalidOperationException($"{result} of {rows} rows were read.");

        return new Measurements { ["MB/s"] = new FileInfo(path).Length / Megabyte / seconds, ["B/row"] = allocated / (double)rows };
    }

    // Repeats the rows at the start of the file.
    private static Measurements MeasureWriting(string path)
    {
        using var reader = BvhReader.Open(path);
        float[] rows = new float[reader.Hierarchy.ChannelCount * 500];
        for (int start = 0; start < rows.Length && reader.TryReadFrame(rows.AsSpan(start, reader.Hierarchy.ChannelCount)); start += reader.Hierarchy.ChannelCount)
        {
        }

        int count = (int)(new FileInfo(path).Length / 4000);
        string target = path + ".written";
        try
        {
            using var writer = new BvhWriter(target, reader.Hierarchy, reader.FrameTime, reader.TextFormat);
            long allocated = GC.GetAllocatedBytesForCurrentThread();
            long start = Stopwatch.GetTimestamp();
            for (int row = 0; row < count; row++)
                writer.WriteFrame(rows.AsSpan(row % 500 * reader.Hierarchy.ChannelCount, reader.Hierarchy.ChannelCount));

            writer.Flush();
            double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
            allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
            return new Measurements { ["MB/s"] = new FileInfo(target).Length / Megabyte / seconds, ["B/row"] = allocated / (double)count };
        }
        finally
        {
            File.Delete(target);
        }
    }

    private static long ReadRows(string path)
    {
        using var reader = BvhReader.Open(path);
        float[] row = new float[reader.Hierarchy.ChannelCount];
        while (reader.TryReadFrame(row))
        {
        }

        return reader.FrameCount;
    }

    // Every line is a row, except the lines above the first row.
    private static long AddBytes(string path)
    {
        using var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1, FileOptions.SequentialScan);
        byte[] piece = new byte[PieceSize];
        long lineFeeds = 0;
        for (int read = stream.Read(piece); read > 0; read = stream.Read(piece))
        {
            foreach (byte letter in piece.AsSpan(0, read))
                lineFeeds += letter == '\n' ? 1 : 0;
        }

        return lineFeeds - Heading(0).Count(letter => letter == '\n');
    }

    private static int Write(string path, long length)
    {
        // The length of the heading depends on the number of rows. A first draft of the heading gives a good estimate.
        var random = new Random(1);
        string[] rows = [.. Enumerable.Range(0, 500).Select(row => Row(row, random))];
        double rowLength = rows.Average(row => row.Length);
        int count = (int)((length - Heading(0).Length) / rowLength);
        using var writer = new StreamWriter(path);
        writer.Write(Heading(count));
        for (int row = 0; row < count; row++)
            writer.Write(rows[row % rows.Length]);

        return count;
    }

    private static string Heading(int rows) =>
        BvhHierarchyText.Create(SkeletonFormat.Default, new ChannelLayout(hasDisplacement: true, hasReference: false))
        + FormattableString.Invariant($"MOTION\r\n\r\nFrames: {rows}\r\nFrame Time: 0.008\r\n");

    // Positions of tens of centimetres and rotations of up to half a circle.
    private static string Row(int row, Random random) => string.Concat(Enumerable.Range(0, 354).Select(index =>
        ((random.NextDouble() - 0.5) * (index % 6 < 3 ? 60 : 360) + Math.Sin(row * 0.01)).ToString("F6", CultureInfo.InvariantCulture) + " ")) + "\r\n";
}
