using System.Text;
using NeuronMocap.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhReaderTests
{
    private static readonly BvhReadOptions Strict = new() { Strict = true };
    private static readonly byte[] Headings = Encoding.UTF8.GetBytes($"{Hierarchy}MOTION\nFrames: 3000\nFrame Time: 0.008\n");

    [Fact]
    public void Hierarchy_and_headings_are_available_before_rows()
    {
        using var reader = new BvhReader(new MemoryStream(Encoding.UTF8.GetBytes(TwoRows)));

        Assert.Equal(["Hips", "Spine"], reader.Hierarchy.Joints.Select(joint => joint.Name));
        Assert.Equal(9, reader.Hierarchy.ChannelCount);
        Assert.Equal(new BvhFrameTime(1, 120), reader.FrameTime);
        Assert.Equal(0.008, reader.DeclaredFrameTime);
        Assert.Equal(2, reader.DeclaredFrameCount);
        Assert.Equal(TwoRows.Length, reader.Length);
        Assert.Equal(0, reader.FrameCount);

        float[] row = new float[10];
        Assert.True(reader.TryReadFrame(row));
        AssertBits([1, 2, 3, 4, 5, 6, 7, 8, 9, 0], row);
        Assert.True(reader.TryReadFrame(row));
        AssertBits([-1, -2, -3, -4, -5, -6, -7, -8, -9, 0], row);
        Assert.False(reader.TryReadFrame(row));
        Assert.False(reader.TryReadFrame(row));
        Assert.Equal(2, reader.FrameCount);
        Assert.Equal(TwoRows.Length, reader.BytesRead);
        Assert.Equal(0, reader.RepairCount);
    }

    // Reads a row as soon as the end of its line arrives, even if that may be half a CR LF, without waiting for more.
    [Theory]
    [InlineData("\n")]
    [InlineData("\r")]
    [InlineData("\r\n")]
    public void A_row_is_read_at_its_line_end(string lineEnd)
    {
        string text = TwoRows.Replace("\n", lineEnd, StringComparison.Ordinal);
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        var stream = new PieceStream(bytes, static () => 1);
        using var reader = new BvhReader(stream);
        int firstRow = text.IndexOf("1 2 3 4", StringComparison.Ordinal);
        Assert.Equal(firstRow + 1, stream.Taken);

        float[] row = new float[9];
        Assert.True(reader.TryReadFrame(row));
        Assert.Equal(text.IndexOf(lineEnd, firstRow, StringComparison.Ordinal) + 1, stream.Taken);
        Assert.True(reader.TryReadFrame(row));
        Assert.Equal(text.Length - lineEnd.Length + 1, stream.Taken);
    }

    [Fact]
    public void Pieces_of_any_size_read_alike_beyond_the_window()
    {
        var random = new Random(7);
        var text = new StringBuilder(Hierarchy + "MOTION\r\nFrames: 4000\r\nFrame Time: 0.0083333\r\n");
        for (int row = 0; row < 4000; row++)
        {
            for (int value = 0; value < 9; value++)
                text.Append(System.Globalization.CultureInfo.InvariantCulture, $"{(random.NextDouble() - 0.5) * 360:F6} ");

            text.Append(row % 1000 == 999 ? "1 " : "").Append("\r\n");
        }

        byte[] bytes = Encoding.UTF8.GetBytes(text.ToString());
        Assert.InRange(bytes.Length, 5 * BvhText.LongestWord, int.MaxValue);
        Assert.EndsWith("4 repairs", BvhReadings.AssertAlike(bytes, seed: 1), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(1 << 20)]
    public void A_row_allocates_nothing(int pieceSize)
    {
        using var reader = new BvhReader(new PieceStream([.. Headings, .. "1.000000 -2.5e-3 3 4 5 6 -7.123456 8 9 \r\n"u8], () => pieceSize, repeatFrom: Headings.Length));
        float[] row = new float[9];
        Allocations.AssertNone(() => Assert.True(reader.TryReadFrame(row)));
    }

    // Neither rows broken across lines nor rows joined on one line allocate, once the list of repairs is full.
    [Fact]
    public void A_repaired_row_allocates_nothing_after_the_list_is_full()
    {
        byte[] rows = "1 2 3\n4 5 6\n7 8 9\n1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9\nx\n1 2 3 4 5 6 7 8 9 10\n1 nan 3 4 5 6 7 8 9\n"u8.ToArray();
        using var reader = new BvhReader(new PieceStream([.. Headings, .. rows], static () => int.MaxValue, repeatFrom: Headings.Length));
        float[] row = new float[9];
        while (reader.RepairCount < 200)
            Assert.True(reader.TryReadFrame(row));

        Allocations.AssertNone(() => Assert.True(reader.TryReadFrame(row)));
    }

    [Fact]
    public void Memory_does_not_grow_with_the_file()
    {
        byte[] few = Repeated(100);
        byte[] many = Repeated(40_000);
        long forFew = LeastAllocated(few);
        long forMany = LeastAllocated(many);

        Assert.InRange(forMany, 1, forFew + 1024);
        Assert.InRange(forFew, 1, 32 * 1024);

        static byte[] Repeated(int rows) =>
            Encoding.UTF8.GetBytes($"{Hierarchy}MOTION\nFrames: {rows}\nFrame Time: 0.008\n{string.Concat(Enumerable.Repeat(Row, rows))}");

        // Reading allocates the same each time. The minimum excludes objects that the runtime creates once, or again after the pool's arrays were
        // collected.
        static long LeastAllocated(byte[] bytes) => Enumerable.Range(0, 5).Select(_ => Allocated(bytes)).Min();

        static long Allocated(byte[] bytes)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            Read(bytes);
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }

        static void Read(byte[] bytes)
        {
            using var reader = new BvhReader(new MemoryStream(bytes));
            float[] row = new float[9];
            while (reader.TryReadFrame(row))
            {
            }
        }
    }

    // Everything in one line, and everything in one word: neither is buffered as a whole.
    [Theory]
    [InlineData("1 2 3 4 5 6 7 8 9 ", 100_000)]
    [InlineData("8", 1_000_000)]
    [InlineData("\0", 1_000_000)]
    [InlineData(" ", 1_000_000)]
    [InlineData("{", 1_000_000)]
    public void Lines_of_any_length_are_read_in_bounded_memory(string part, int count)
    {
        byte[] bytes = Encoding.UTF8.GetBytes($"{Hierarchy}MOTION\nFrames: 1\nFrame Time: 0.008\n{Row}{string.Concat(Enumerable.Repeat(part, count))}\n{Row}");
        BvhReadings.DescribeRows(new MemoryStream(Encoding.UTF8.GetBytes(TwoRows)));
        using var reader = new BvhReader(new MemoryStream(bytes));
        float[] row = new float[9];
        long before = GC.GetAllocatedBytesForCurrentThread();
        while (reader.TryReadFrame(row))
        {
        }

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 16 * 1024);
        Assert.Equal(part.Contains('9', StringComparison.Ordinal) ? count + 2 : 2, reader.FrameCount);
        AssertBits([1, 2, 3, 4, 5, 6, 7, 8, 9], row.AsSpan(0, 9));
        BvhReadings.AssertAlike(bytes.AsSpan(0, Math.Min(bytes.Length, 150_000)).ToArray(), seed: 2);
    }

    [Fact]
    public void Rows_of_a_long_line_are_separated_early()
    {
        string ten = string.Concat(Enumerable.Repeat("1 2 3 4 5 6 7 8 9 ", 10));
        BvhDocument document = ParseRows(10, $"8 8\n{ten}10 11\n");

        Assert.Equal(10, document.FrameCount);
        Assert.Equal(
            [
                new BvhRepair(19, 1, "A row has 2 values instead of 9; it is skipped.") { SkipsRow = true },
                new BvhRepair(20, 1, "More than 8 rows are on one line; every 9 values are read as one."),
                new BvhRepair(20, 181, "A row has 2 values instead of 9; it is skipped.") { SkipsRow = true },
            ],
            document.Repairs);
    }

    [Fact]
    public void Progress_is_reported_while_reading()
    {
        var told = new List<long>();
        var options = new BvhReadOptions { Progress = new Told(told) };
        byte[] bytes = Encoding.UTF8.GetBytes(TwoRows);
        BvhDocument.Load(new PieceStream(bytes, static () => 100), options);

        Assert.Equal(Enumerable.Range(1, bytes.Length / 100).Select(piece => piece * 100L).Append(bytes.Length).Append(bytes.Length), told);
    }

    [Fact]
    public void Streams_are_closed_as_asked()
    {
        byte[] good = Encoding.UTF8.GetBytes(TwoRows);
        var stream = new PieceStream(good, static () => 10);
        new BvhReader(stream, leaveOpen: true).Dispose();
        Assert.False(stream.IsClosed);

        stream = new PieceStream(good, static () => 10);
        var reader = new BvhReader(stream);
        reader.Dispose();
        reader.Dispose();
        Assert.True(stream.IsClosed);
        Assert.Throws<ObjectDisposedException>(() => reader.TryReadFrame(new float[9]));

        stream = new PieceStream("x"u8.ToArray(), static () => 10);
        Assert.Throws<BvhFormatException>(() => new BvhReader(stream));
        Assert.False(stream.IsClosed);
        BvhDocument.Load(new PieceStream(good, static () => 10));
    }

    [Fact]
    public void A_refused_file_is_closed()
    {
        string path = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".bvh");
        try
        {
            File.WriteAllText(path, "x");
            Assert.Throws<BvhFormatException>(() => BvhReader.Open(path));
            Assert.Throws<BvhFormatException>(() => BvhDocument.Load(path));
            using (new FileStream(path, FileMode.Open, FileAccess.ReadWrite, FileShare.None))
            {
            }

            File.WriteAllText(path, TwoRows);
            using var reader = BvhReader.Open(path);
            Assert.True(reader.TryReadFrame(new float[9]));
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    public void A_failed_reader_does_not_continue()
    {
        using var reader = new BvhReader(new MemoryStream(Encoding.UTF8.GetBytes($"{Hierarchy}MOTION\nFrames: 2\nFrame Time: 0.008\n{Row}x\n{Row}")), Strict);
        float[] row = new float[9];
        Assert.True(reader.TryReadFrame(row));
        BvhFormatException refusal = Assert.Throws<BvhFormatException>(() => reader.TryReadFrame(row));
        Assert.Equal("line 20, column 1: 'x' is not a number.", refusal.Message);
        Assert.Throws<InvalidOperationException>(() => reader.TryReadFrame(row));
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        using var reader = new BvhReader(new MemoryStream(Encoding.UTF8.GetBytes(TwoRows)));

        Assert.Throws<ArgumentException>(() => reader.TryReadFrame(new float[8]));
        Assert.True(reader.TryReadFrame(new float[9]));
        Assert.Throws<ArgumentNullException>(() => new BvhReader(null!));
        Assert.Throws<ArgumentNullException>(() => BvhDocument.Load((Stream)null!));
        Assert.Throws<FileNotFoundException>(() => BvhReader.Open("/nowhere.bvh"));
    }

    [Theory]
    [InlineData("9 10 11", 1, "The file has no HIERARCHY; it begins with '9'.")]
    [InlineData(TwoRows + "x", 22, "'x' is not a number.")]
    [InlineData(TwoRows + Row, 18, "The file declares '2' frames but has 3 rows.")]
    public void Strict_reading_names_the_defect(string text, int line, string told)
    {
        BvhFormatException refusal = Assert.Throws<BvhFormatException>(() => BvhDocument.Parse(Encoding.UTF8.GetBytes(text), Strict));
        Assert.Equal(line, refusal.Line);
        Assert.EndsWith(": " + told, refusal.Message, StringComparison.Ordinal);
    }

    private sealed class Told(List<long> told) : IProgress<long>
    {
        public void Report(long value) => told.Add(value);
    }
}
