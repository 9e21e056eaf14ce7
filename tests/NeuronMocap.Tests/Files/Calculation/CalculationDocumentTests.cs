using System.Text;
using NeuronMocap.Calculation;

namespace NeuronMocap.Tests.Calculation;

public sealed class CalculationDocumentTests
{
    public static TheoryData<int> Widths => [946, 338];

    [Theory, MemberData(nameof(Widths))]
    public void Rows_are_read_exactly(int columns)
    {
        var document = CalculationDocument.Parse(CalculationText.Utf8(CalculationText.Rows(3, columns)));

        Assert.Equal(3, document.FrameCount);
        Assert.Equal(columns, document.ValueCount);
        Assert.Equal(120, document.FrameRate);
        Assert.Empty(document.Repairs);
        for (int row = 0; row < 3; row++)
            Assert.Equal(CalculationText.Values(row, columns), document.GetValues(row));
    }

    [Theory]
    [InlineData("\t", "\t\r\n")]
    [InlineData("\t", "\n")]
    [InlineData(" ", "\r")]
    [InlineData("   ", " \t \n")]
    [InlineData("\t", "\t\r\n\r\n  \r\n")]
    public void Any_white_space_is_accepted(string separator, string end)
    {
        var document = CalculationDocument.Parse(CalculationText.Utf8("\n \t\n" + CalculationText.Rows(3, separator: separator, end: end)));

        Assert.Equal(3, document.FrameCount);
        Assert.Empty(document.Repairs);
        Assert.Equal(CalculationText.Values(2), document.GetValues(2));
    }

    [Fact]
    public void The_header_lines_are_kept()
    {
        string names = string.Join('\t', Enumerable.Range(0, 946).Select(column => $"{(column / 16) + 1:00}-X-{column}"));
        string header = $"\uFEFFAxis Neuron 演员一\r\nFrames: 2\r\n120\r\n\r\n{names}\t\r\n";
        byte[] text = CalculationText.Utf8(header + CalculationText.Rows(2));

        var document = CalculationDocument.Parse(text, new CalculationReadOptions { Strict = true });

        Assert.Equal(2, document.FrameCount);
        Assert.Equal(header, Encoding.UTF8.GetString(document.TextFormat.Header.Span));
        Assert.Equal(text, Write(document));
    }

    [Fact]
    public void Missing_settings_come_from_the_options()
    {
        var options = new CalculationReadOptions { FrameRate = 60, AvatarName = "演员一", AvatarIndex = 3 };
        var document = CalculationDocument.Parse(CalculationText.Utf8(CalculationText.Rows(2)), options);

        CalculationFrame frame = document.GetFrame(1);

        Assert.Equal(60, document.FrameRate);
        Assert.Equal("演员一", frame.AvatarName);
        Assert.Equal(3, frame.AvatarIndex);
        Assert.Equal(1u, frame.FrameIndex);
        Assert.Equal(59, frame.BoneCount);
        Assert.Equal(CalculationText.Value(1, 15 * 16), frame.GetPosition(Bone.Head).X);
        Assert.Equal(CalculationText.Value(1, (58 * 16) + 2 + 6), frame.GetSensorRotation(Bone.LeftHandPinky3).W);
        Assert.Equal(frame.LeftFootContact, CalculationText.Value(1, 336) == 1);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void An_invalid_rate_is_refused(double rate) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new CalculationReadOptions { FrameRate = rate });

    [Fact]
    public void Numbers_are_read_as_the_nearest_float()
    {
        string[] words = ["-0.0000", "16777217", "1.00000017881393432617187500000000001", "1e-46", "1e39", "nan", "-1.#IND00", "+.5", "5."];
        string row = string.Join('\t', words.Concat(Enumerable.Repeat("0", 946 - words.Length)));

        var document = CalculationDocument.Parse(CalculationText.Utf8(row + "\n"));

        ReadOnlySpan<float> values = document.GetValues(0);
        Assert.Equal(BitConverter.SingleToInt32Bits(-0f), BitConverter.SingleToInt32Bits(values[0]));
        Assert.Equal([16777216f, 1.00000024f, 0f, float.PositiveInfinity, float.NaN, float.NaN, 0.5f, 5f], values[1..9].ToArray());
        CalculationRepair repair = Assert.Single(document.Repairs);
        Assert.Equal(1, repair.Line);
        Assert.Equal("-0.0000\t16777217\t1.00000017881393432617187500000000001\t1e-46\t".Length + 1, repair.Column);
    }

    [Fact]
    public void Invalid_rows_are_dropped_and_reported()
    {
        string broken = CalculationText.Row(1).Replace("\t", "\tx", StringComparison.Ordinal);
        string text = CalculationText.Row(0, 500) + "\n" + CalculationText.Row(0) + "\r\n" + broken + "\r\nFrames: 3\r\n"
            + CalculationText.Row(2, 945) + "\r\n" + CalculationText.Row(3) + "\t1.5\r\n" + CalculationText.Row(4, 338) + "\r\n" + CalculationText.Row(5, 7);

        var document = CalculationDocument.Parse(CalculationText.Utf8(text));

        Assert.Equal(2, document.FrameCount);
        Assert.Equal(CalculationText.Values(0), document.GetValues(0));
        Assert.Equal(CalculationText.Values(3), document.GetValues(1));
        Assert.Equal([1, 3, 4, 5, 6, 7, 8], document.Repairs.Select(repair => repair.Line).ToArray());
        Assert.Equal(7, document.RepairCount);
        Assert.Equal(broken.IndexOf('x', StringComparison.Ordinal) + 1, document.Repairs[1].Column);
        Assert.Contains("'Frames:' is not a number", document.Repairs[2].Description, StringComparison.Ordinal);
        Assert.Contains("945 values instead of 946", document.Repairs[3].Description, StringComparison.Ordinal);
        Assert.Contains("947 values instead of 946", document.Repairs[4].Description, StringComparison.Ordinal);
        Assert.Contains("The file ends after 7 values", document.Repairs[6].Description, StringComparison.Ordinal);
        Assert.StartsWith("line 8, column ", document.Repairs[6].ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Strict_reading_refuses_repairs()
    {
        byte[] text = CalculationText.Utf8(CalculationText.Rows(2) + CalculationText.Row(2, 945) + "\n");

        var refusal = Assert.Throws<CalculationFormatException>(
            () => CalculationDocument.Parse(text, new CalculationReadOptions { Strict = true }));

        Assert.Equal((3, 1), (refusal.Line, refusal.Column));
        Assert.StartsWith("line 3, column 1: A row has 945 values", refusal.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("")]
    [InlineData("\r\n\r\n")]
    [InlineData("1 2 3\n4 5 6\n")]
    [InlineData("HIERARCHY\nROOT Hips\n{\n")]
    public void Other_files_are_refused(string text)
    {
        var refusal = Assert.Throws<CalculationFormatException>(() => CalculationDocument.Parse(CalculationText.Utf8(text)));
        Assert.True(refusal.Line > 0 && refusal.Column > 0);
    }

    [Fact]
    public void A_file_without_line_ends_is_refused_with_bounded_memory() =>
        Assert.Throws<CalculationFormatException>(() => CalculationDocument.Parse(new byte[5_000_000]));

    [Fact]
    public void A_tail_of_zeros_loses_no_row()
    {
        byte[] text = [.. CalculationText.Utf8(CalculationText.Rows(2)), .. new byte[3_000_000]];

        var document = CalculationDocument.Parse(text);

        Assert.Equal(2, document.FrameCount);
        Assert.InRange(document.RepairCount, 1, 3);
    }

    [Fact]
    public void At_most_a_hundred_repairs_are_listed()
    {
        string text = CalculationText.Rows(1) + string.Concat(Enumerable.Repeat("x\n", 250)) + CalculationText.Row(1);

        var document = CalculationDocument.Parse(CalculationText.Utf8(text));

        Assert.Equal(2, document.FrameCount);
        Assert.Equal(250, document.RepairCount);
        Assert.Equal(CalculationDocument.MaxListedRepairs, document.Repairs.Count);
    }

    [Fact]
    public void Every_row_before_a_cut_is_read()
    {
        byte[] text = CalculationText.Utf8(CalculationText.Rows(3, 338));
        int rowLength = CalculationText.Row(0, 338).Length + 3;
        int secondLength = CalculationText.Row(1, 338).Length + 3;
        for (int length = rowLength; length < text.Length; length += length % rowLength < 16 ? 1 : 7)
        {
            var document = CalculationDocument.Parse(text.AsSpan(0, length));

            int whole = length >= rowLength + secondLength - 3 ? 2 : 1;
            Assert.True(document.FrameCount == whole, $"Cut after {length} bytes: {document.FrameCount} frames.");
            Assert.Equal(CalculationText.Values(whole - 1, 338), document.GetValues(whole - 1));
        }
    }

    internal static byte[] Write(CalculationDocument document)
    {
        using var stream = new MemoryStream();
        document.Save(stream);
        return stream.ToArray();
    }
}
