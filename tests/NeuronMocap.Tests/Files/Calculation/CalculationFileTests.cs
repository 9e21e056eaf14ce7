using FsCheck;
using FsCheck.Fluent;
using NeuronMocap.Calculation;

namespace NeuronMocap.Tests.Calculation;

public sealed class CalculationFileTests
{
    private static readonly string[] Spaces = [" ", "\t", "  ", "\t ", "\v"];

    [Fact]
    public void Rows_in_any_format_round_trip_bit_for_bit()
    {
        Gen<uint> bits = Gen.Choose(int.MinValue, int.MaxValue).Select(number => (uint)number);
        Gen<Sample> samples =
            from rows in Gen.Choose(1, 3)
            from columns in Gen.Elements(338, 946)
            from pattern in bits.ArrayOf(16)
            from separator in Gen.Elements(Spaces)
            from decimals in Gen.Choose(0, 16)
            from end in Gen.Elements("\n", "\r\n", "\r", "\t\r\n", " \n\n")
            from last in Gen.Elements(null, "", "\t", "\n")
            select new Sample(rows, columns, pattern, separator, decimals, end, last);

        Properties.Hold(samples, static _ => [], 60, static sample =>
        {
            using var stream = new MemoryStream();
            using (var writer = new CalculationFileWriter(stream, sample.Columns, sample.Format, leaveOpen: true))
            {
                for (int row = 0; row < sample.Rows; row++)
                    writer.WriteFrame(sample.Row(row));
            }

            var document = CalculationDocument.Parse(stream.ToArray());
            Assert.Equal(sample.Rows, document.FrameCount);
            for (int row = 0; row < sample.Rows; row++)
            {
                int[] expected = [.. sample.Row(row).Select(Bits)];
                Assert.Equal(expected, document.GetValues(row).ToArray().Select(Bits));
            }
        });
    }

    [Fact]
    public void A_reader_in_small_pieces_reads_the_same()
    {
        byte[] text = CalculationText.Utf8("Header 1\r\n" + CalculationText.Rows(7, 338) + "x\r\r\n" + CalculationText.Rows(2, 338, end: "\r"));
        foreach (int piece in (int[])[1, 2, 3, 1000, 65_536])
        {
            using var reader = new CalculationFileReader(new PiecewiseStream(text, piece));
            float[] values = new float[reader.ValueCount];
            int rows = 0;
            for (; reader.TryReadFrame(values); rows++)
                Assert.Equal(CalculationText.Values(rows < 7 ? rows : rows - 7, 338), values);

            Assert.Equal((9, 9L, 1), (rows, reader.FrameCount, reader.RepairCount));
            Assert.Equal(text.Length, reader.BytesRead);
            Assert.Equal(9, reader.Repairs[0].Line);
        }
    }

    [Fact]
    public void Reading_and_writing_rows_allocates_nothing()
    {
        using var reader = new CalculationFileReader(new PieceStream(CalculationText.Utf8(CalculationText.Rows(250)), static () => int.MaxValue, repeatFrom: 0));
        using var writer = new CalculationFileWriter(Stream.Null, reader.ValueCount);
        float[] values = new float[reader.ValueCount];
        Allocations.AssertNone(Copy, calls: 10);

        void Copy()
        {
            Assert.True(reader.TryReadFrame(values));
            writer.WriteFrame(values);
        }
    }

    [Fact]
    public void Progress_runs_from_zero_to_the_file_length()
    {
        byte[] text = CalculationText.Utf8(CalculationText.Rows(20));
        using var reader = new CalculationFileReader(new MemoryStream(text));
        float[] values = new float[reader.ValueCount];
        Assert.Equal(text.Length, reader.Length);
        long position = 0;
        while (reader.TryReadFrame(values))
        {
            Assert.InRange(reader.BytesRead, position + 1, text.Length);
            position = reader.BytesRead;
        }

        Assert.Equal(text.Length, reader.BytesRead);
    }

    [Fact]
    public void Missing_row_arguments_are_refused()
    {
        Assert.Throws<ArgumentException>(() => new CalculationFileWriter(new MemoryStream(), 339));
        Assert.Throws<ArgumentException>(() => new CalculationTextFormat { Separator = "" });
        Assert.Throws<ArgumentException>(() => new CalculationTextFormat { Separator = ";" });
        Assert.Throws<ArgumentException>(() => new CalculationTextFormat { RowEnd = "\t" });
        Assert.Throws<ArgumentException>(() => new CalculationTextFormat { LastRowEnd = "." });
        Assert.Throws<ArgumentOutOfRangeException>(() => new CalculationTextFormat { Decimals = 17 });
        using var reader = new CalculationFileReader(new MemoryStream(CalculationText.Utf8(CalculationText.Rows(1))));
        Assert.Throws<ArgumentException>(() => reader.TryReadFrame(new float[945]));
        var writer = new CalculationFileWriter(new MemoryStream(), 338);
        Assert.Throws<ArgumentException>(() => writer.WriteFrame(new float[339]));
        writer.Dispose();
        writer.Dispose();
        Assert.Throws<ObjectDisposedException>(() => writer.WriteFrame(new float[338]));
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(300, 0)]
    [InlineData(1, 300)]
    [InlineData(300, 300)]
    public void Blanks_of_any_length_are_read(int between, int behind)
    {
        string end = new string(' ', behind) + "\n";
        byte[] text = CalculationText.Utf8(CalculationText.Rows(3, separator: new string(' ', between), end: end) + new string(' ', 300));

        var document = CalculationDocument.Parse(text);
        using var written = new MemoryStream();
        document.Save(written);

        Assert.Empty(document.Repairs);
        var again = CalculationDocument.Parse(written.ToArray());
        Assert.Equal(3, again.FrameCount);
        Assert.Equal(CalculationText.Values(2), again.GetValues(2));
    }

    [Fact]
    public void A_stream_stays_open_when_asked()
    {
        byte[] text = CalculationText.Utf8(CalculationText.Rows(30));
        var told = new Told();
        using var stream = new MemoryStream(text);
        Assert.Equal(30, CalculationDocument.Load(stream, new CalculationReadOptions { Progress = told }).FrameCount);
        Assert.True(told.Values.Count > 2);
        Assert.Equal(text.Length, told.Values[^1]);
        Assert.Equal(told.Values.Order(), told.Values);

        stream.Position = 0;
        var reader = new CalculationFileReader(stream);
        reader.Dispose();
        Assert.False(stream.CanRead);
        Assert.Throws<ObjectDisposedException>(() => reader.TryReadFrame(new float[946]));
    }

    [Fact]
    public void Files_are_opened_and_created_by_path()
    {
        string path = Path.Combine(Path.GetTempPath(), $"neuronmocap-{Guid.NewGuid():N}.calc");
        try
        {
            using (var writer = new CalculationFileWriter(path, 946))
                writer.WriteFrame(CalculationText.Values(4));

            CalculationDocument document = CalculationDocument.Load(path);
            Assert.Equal(CalculationText.Values(4), document.GetValues(0));
            document.Save(path);
            Assert.Equal(CalculationText.Utf8(CalculationText.Row(4) + "\t\r\n"), File.ReadAllBytes(path));
            File.WriteAllText(path, "nothing");
            Assert.Throws<CalculationFormatException>(() => CalculationFileReader.Open(path));
            Assert.Throws<ArgumentException>(() => new CalculationFileWriter(path, 945));
            Assert.Equal("nothing", File.ReadAllText(path));
        }
        finally
        {
            File.Delete(path);
        }

        Assert.Throws<FileNotFoundException>(() => CalculationDocument.Load(path));
    }

    private static int Bits(float value) => float.IsNaN(value) ? BitConverter.SingleToInt32Bits(float.NaN) : BitConverter.SingleToInt32Bits(value);

    private sealed record Sample(int Rows, int Columns, uint[] Pattern, string Separator, int Decimals, string End, string? Last)
    {
        public CalculationTextFormat Format => new() { Separator = Separator, Decimals = Decimals, RowEnd = End, LastRowEnd = Last };

        public float[] Row(int row) =>
        [
            .. Enumerable.Range(0, Columns).Select(column =>
                BitConverter.Int32BitsToSingle((int)(Pattern[column % Pattern.Length] + ((uint)(column + row) * 2_654_435_761u)))),
        ];
    }

    private sealed class Told : IProgress<long>
    {
        public List<long> Values { get; } = [];

        public void Report(long value) => Values.Add(value);
    }

    // Returns a few bytes at a time.
    private sealed class PiecewiseStream(byte[] bytes, int piece) : MemoryStream(bytes)
    {
        public override int Read(byte[] buffer, int offset, int count) => base.Read(buffer, offset, Math.Min(count, piece));
    }
}
