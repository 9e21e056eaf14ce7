using System.Text;
using NeuronMocap.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhMotionTests
{
    private static readonly float[] RowValues = [1, 2, 3, 4, 5, 6, 7, 8, 9];

    [Fact]
    public void Rows_are_read_exactly()
    {
        BvhDocument document = Parse(TwoRows);

        Assert.Equal(2, document.FrameCount);
        AssertBits(RowValues, document.GetValues(0));
        AssertBits([-1, -2, -3, -4, -5, -6, -7, -8, -9], document.GetValues(1));
        Assert.Equal(0.008, document.DeclaredFrameTime);
        Assert.Equal(120, document.FrameRate);
        Assert.Equal(0, document.RepairCount);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(2)]
    [InlineData(int.MaxValue)]
    public void A_frame_out_of_range_is_refused(int index)
    {
        BvhDocument document = Parse(TwoRows);
        Assert.Throws<ArgumentOutOfRangeException>(() => document.GetValues(index).Length);
    }

    [Fact]
    public void Trailing_spaces_are_no_value() =>
        AssertSame(ParseRows(1, Row), ParseRows(1, "  1 2 3 4 5 6 7 8 9 \t \r\n"));

    [Fact]
    public void Negative_zero_stays_negative() =>
        AssertBits([0, -0f, -0f, 0, 0, -0f, 1, 0, 0], ParseRows(1, "0.000000 -0.000000 -0 0 +0 -0e5 1 0 0").GetValues(0));

    [Fact]
    public void Two_decimals_and_exponents_are_read()
    {
        BvhDocument document = ParseRows(1, "1.25 -179.99 .5 5. 1e2 -2.5E-3 1.234567e-05 +3.4e+38 1e-45");

        AssertBits([1.25f, -179.99f, 0.5f, 5, 100, -0.0025f, 1.234567e-05f, 3.4e38f, 1e-45f], document.GetValues(0));
        Assert.Empty(document.Repairs);
    }

    [Theory]
    [InlineData("nan", float.NaN)]
    [InlineData("NaN", float.NaN)]
    [InlineData("-nan(ind)", float.NaN)]
    [InlineData("-1.#IND00", float.NaN)]
    [InlineData("1.#QNAN", float.NaN)]
    [InlineData("Infinity", float.PositiveInfinity)]
    [InlineData("+inf", float.PositiveInfinity)]
    [InlineData("-1.#INF00", float.NegativeInfinity)]
    [InlineData("-1e39", float.NegativeInfinity)]
    public void Values_that_are_not_finite_are_kept_and_reported(string text, float expected)
    {
        BvhDocument document = ParseRows(1, $"1 2 3 4 5 6 7 8 {text}\n");

        Assert.Equal(expected, document.GetValues(0)[8]);
        Assert.Equal(19, OnlyRepair(document).Line);
    }

    [Fact]
    public void Zero_frames_are_valid()
    {
        BvhDocument document = ParseRows(0, "");

        Assert.Equal(0, document.FrameCount);
        Assert.Equal(0.008, document.DeclaredFrameTime);
        Assert.Empty(document.Repairs);
    }

    [Theory]
    [InlineData("0")]
    [InlineData("3")]
    [InlineData("-6.27744e+66")]
    [InlineData("4000000000")]
    [InlineData("1.5")]
    [InlineData("many")]
    [InlineData("nan")]
    [InlineData("")]
    public void All_rows_are_read_whatever_number_the_file_declares(string frames)
    {
        BvhDocument document = Parse($"{Hierarchy}MOTION\nFrames: {frames}\nFrame Time: 0.008\n{Row}{Row}");

        Assert.Equal(2, document.FrameCount);
        Assert.Equal(new BvhRepair(17, frames.Length == 0 ? 1 : 9, $"The file declares '{frames}' frames but has 2 rows; all rows are read."), OnlyRepair(document));
    }

    [Fact]
    public void A_missing_frame_count_is_reported()
    {
        BvhDocument document = Parse($"{Hierarchy}MOTION\nFrame Time: 0.008\n{Row}");

        Assert.Equal(1, document.FrameCount);
        Assert.Equal(new BvhRepair(16, 1, "The number of frames is missing; rows found: 1."), OnlyRepair(document));
    }

    [Theory]
    [InlineData("Frames: 1\nFrame Time: 0.008\n")]
    [InlineData("Frame Time: 0.008\nFrames: 1\n")]
    [InlineData("Frames 1\nFrame Time 0.008\n")]
    [InlineData("Frames:1\nFrame Time:0.008\n")]
    [InlineData("\tframes : 1\n frame\ttime  : 0.008\n")]
    [InlineData("\n\n\nFrames: 1\n\nFrame Time: 0.008\n\n")]
    [InlineData("FRAMES: 1 FRAME TIME: 0.008 ")]
    public void Both_headings_are_read_in_any_layout(string headings) =>
        AssertSame(ParseRows(1, Row), Parse($"{Hierarchy}MOTION\n{headings}{Row}"));

    [Fact]
    public void A_missing_MOTION_keyword_is_reported()
    {
        BvhDocument document = Parse($"{Hierarchy}Frames: 1\nFrame Time: 0.008\n{Row}");

        AssertBits(RowValues, document.GetValues(0));
        Assert.Equal(new BvhRepair(16, 1, "The word MOTION is missing; it is added here."), OnlyRepair(document));
    }

    [Fact]
    public void Motion_without_anything_after_it_has_no_frames()
    {
        BvhDocument document = Parse(Hierarchy + "MOTION\n");

        Assert.Equal(0, document.FrameCount);
        Assert.Equal([16, 16], document.Repairs.Select(repair => repair.Line));
    }

    [Fact]
    public void Extra_values_of_a_row_are_dropped()
    {
        BvhDocument document = ParseRows(2, $"1 2 3 4 5 6 7 8 9 10\n{Row}");

        AssertBits([.. RowValues, .. RowValues], Values(document));
        Assert.Equal(new BvhRepair(19, 1, "A row has 10 values instead of 9; the first 9 are read."), OnlyRepair(document));
    }

    [Theory]
    [InlineData("1 2 3 4 5 6 7 8\n" + Row, 19)]
    [InlineData(Row + "1 2 3 4 5 6 7 8", 20)]
    [InlineData("1 2 3\n4 5 6 7\n" + Row, 19)]
    [InlineData("8\n9 9 9 9 9 9 9 9 9 9\n", 19)]
    public void A_short_row_is_dropped(string rows, int line)
    {
        BvhDocument document = ParseRows(1, rows);

        Assert.Equal(1, document.FrameCount);
        Assert.EndsWith(" instead of 9; it is skipped.", document.Repairs[0].Description, StringComparison.Ordinal);
        Assert.Equal(line, document.Repairs[0].Line);
    }

    [Theory]
    [InlineData("1 2 3\n4 5 6\n7 8 9\n1 2 3 4 5 6 7 8 9")]
    [InlineData("1 2 3 4 5\n\n6 7 8 9 1 2 3 4 5 6 7 8 9")]
    [InlineData("1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9")]
    public void Rows_across_lines_are_separated_by_length(string rows)
    {
        BvhDocument document = ParseRows(2, rows);

        AssertBits([.. RowValues, .. RowValues], Values(document));
        Assert.Equal(19, OnlyRepair(document).Line);
    }

    [Theory]
    [InlineData("}")]
    [InlineData("1 2 3 4 x 6 7 8 9")]
    [InlineData("1,5 2 3 4 5 6 7 8 9")]
    [InlineData("\0\0\0\0")]
    [InlineData("1 2 3 4 5 6 7 8 9f")]
    public void A_line_that_is_no_row_is_skipped(string garbage)
    {
        BvhDocument document = ParseRows(2, $"{Row}{garbage}\n{Row}");

        AssertBits([.. RowValues, .. RowValues], Values(document));
        BvhRepair repair = OnlyRepair(document);
        Assert.Equal(20, repair.Line);
        Assert.Contains("is not a number", repair.Description, StringComparison.Ordinal);
        Assert.Equal((1, 1), (document.SkippedRowCount, document.InnerSkippedRowCount));
    }

    [Fact]
    public void A_skipped_line_at_the_end_shifts_no_frame()
    {
        BvhDocument document = ParseRows(2, $"{Row}{Row}1 2 3\n");
        Assert.Equal((1, 0), (document.SkippedRowCount, document.InnerSkippedRowCount));
    }

    [Theory]
    [InlineData("\u001a")]
    [InlineData("\u001a\r\n")]
    [InlineData("\u001a\0\0\0")]
    [InlineData("\0\0\n\0\0")]
    public void Padding_after_the_last_row_is_the_end(string padding)
    {
        foreach (string end in (string[])[padding, "\n" + padding])
        {
            byte[] text = Encoding.ASCII.GetBytes($"{Hierarchy}MOTION\nFrames: 1\nFrame Time: 0.01\n{Row.TrimEnd()}{end}");
            BvhReadings.AssertAlike(text, seed: 1);
            BvhDocument document = BvhDocument.Parse(text);
            AssertBits(RowValues, Values(document));
            Assert.Empty(document.Repairs);
        }
    }

    [Fact]
    public void Padding_may_be_longer_than_a_word()
    {
        BvhDocument document = ParseRows(1, Row + new string('\0', 1 << 18));
        AssertBits(RowValues, Values(document));
        Assert.Empty(document.Repairs);
    }

    [Fact]
    public void Padding_before_more_rows_is_a_skipped_line()
    {
        BvhDocument document = ParseRows(2, $"{Row}\0\0 1 2\n\0\n{Row}");
        AssertBits([.. RowValues, .. RowValues], Values(document));
        Assert.Equal([20, 21], document.Repairs.Select(static repair => repair.Line));
        Assert.All(document.Repairs, static repair => Assert.True(repair.SkipsRow));
    }

    [Theory]
    [InlineData("1,5", true)]
    [InlineData("-99,963745", true)]
    [InlineData("1,5,2", false)]
    [InlineData("1,", false)]
    [InlineData(",5", false)]
    [InlineData("x,5", false)]
    public void A_decimal_comma_is_explained(string word, bool isExplained)
    {
        BvhRepair repair = OnlyRepair(ParseRows(1, $"{Row}{word} 2 3 4 5 6 7 8 9\n"));
        Assert.Equal(isExplained, repair.Description.Contains("decimal points, not commas", StringComparison.Ordinal));
        Assert.True(repair.SkipsRow);
    }

    [Fact]
    public void Several_motion_blocks_form_one_take()
    {
        string second = "MOTION\n\nFrames: 1\nFrame Time: 0.017\n9 8 7 6 5 4 3 2 1\n";
        BvhDocument document = Parse(TwoRows + second + "MOTION\n");

        Assert.Equal(3, document.FrameCount);
        AssertBits([9, 8, 7, 6, 5, 4, 3, 2, 1], document.GetValues(2));
        Assert.Equal(0.008, document.DeclaredFrameTime);
        Assert.Equal(
            [
                new BvhRepair(22, 1, "Another MOTION begins here; its rows follow those before it."),
                new BvhRepair(25, 13, "Another frame time is given, '0.017'; it is ignored."),
                new BvhRepair(27, 1, "Another MOTION begins here; its rows follow those before it."),
                new BvhRepair(27, 1, "The number of frames is missing; rows found: 0."),
            ],
            document.Repairs);
    }

    [Fact]
    public void Reading_stops_at_a_second_hierarchy()
    {
        BvhDocument document = Parse(TwoRows + TwoRows);

        AssertBits(Values(Parse(TwoRows)), Values(document));
        Assert.Equal(22, OnlyRepair(document).Line);
    }

    [Fact]
    public void A_hundred_thousand_blank_lines_are_skipped()
    {
        string blank = new('\n', 138_000);
        BvhDocument document = Parse($"{Hierarchy}MOTION\n{blank}Frames: 1\nFrame Time: 0.008\n{blank}{Row}{blank}x");

        AssertBits(RowValues, Values(document));
        Assert.Equal(20 + (3 * 138_000), OnlyRepair(document).Line);
    }

    [Fact]
    public void Joints_without_channels_have_no_frames()
    {
        BvhDocument document = Parse("HIERARCHY\nROOT a {\nOFFSET 0 0 0\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n1 2 3\n");

        Assert.Equal((0, 0), (document.ChannelCount, document.FrameCount));
        Assert.Contains(document.Repairs, repair => repair.Line == 8);
    }

    [Fact]
    public void A_hundred_repairs_are_listed_and_all_are_counted()
    {
        BvhDocument document = ParseRows(0, string.Concat(Enumerable.Repeat("x\n", 5000)));

        Assert.Equal(BvhDocument.MaxListedRepairs, document.Repairs.Count);
        Assert.Equal(5000, document.RepairCount);
        Assert.Equal(new BvhRepair(19, 1, "'x' is not a number; the line is skipped.") { SkipsRow = true }, document.Repairs[0]);
        Assert.Equal("line 118, column 1: 'x' is not a number; the line is skipped.", document.Repairs[99].ToString());
    }

    [Fact]
    public void A_file_and_its_text_read_alike()
    {
        string path = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".bvh");
        try
        {
            File.WriteAllText(path, TwoRows);
            AssertSame(Parse(TwoRows), BvhDocument.Load(path));
        }
        finally
        {
            File.Delete(path);
        }

        Assert.Throws<FileNotFoundException>(() => BvhDocument.Load(path));
    }
}
