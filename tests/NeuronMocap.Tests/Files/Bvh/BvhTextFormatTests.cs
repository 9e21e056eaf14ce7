using NeuronMocap.Bvh;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

public class BvhTextFormatTests
{
    [Fact]
    public void A_hierarchy_alone_has_no_row_format() => Assert.Equal(
        BvhTextFormat.AxisNeuron with { LineEnd = "\n", OffsetDecimals = 0 },
        Parse(Hierarchy).TextFormat);

    [Theory]
    [InlineData("\n")]
    [InlineData("\r")]
    [InlineData("\r\n")]
    public void The_layout_of_another_program_is_found(string lineEnd)
    {
        string text = ("HIERARCHY\nROOT a\n{\n\tOFFSET 1.25 2.50 -0.125\n\tCHANNELS 2 Xrotation Yrotation\n\tEnd Site\n\t{\n\t\tOFFSET 0.00 1.00 0.00\n\t}\n}\n"
            + "MOTION\nFrames: 2\nFrame Time: .0333\n1.0\t2.00\n1\t2").Replace("\n", lineEnd, StringComparison.Ordinal);

        var expected = new BvhTextFormat
        {
            LineEnd = lineEnd,
            Indentation = "\t",
            Separator = "\t",
            OffsetDecimals = 2,
            ValueDecimals = 1,
            HasSeparatorAtRowEnd = false,
            HasBlankLineAfterMotion = false,
            HasByteOrderMark = true,
            FrameTimeText = ".0333",
        };
        Assert.Equal(expected, Parse("\uFEFF" + text).TextFormat);
    }

    // If it were kept, it would precede every written line and turn a few bytes into gigabytes.
    [Fact]
    public void Very_long_blanks_are_no_layout()
    {
        string blanks = new(' ', 100_000);
        BvhDocument document = Parse($"HIERARCHY\nROOT a\n{{\n{blanks}OFFSET 0 0 0\nCHANNELS 2 Xrotation Yrotation\n}}\nMOTION\nFrames: 1\nFrame Time: 0.008\n1{blanks}2\n");

        Assert.Equal(BvhTextFormat.AxisNeuron.Indentation, document.TextFormat.Indentation);
        Assert.True(document.TextFormat.Separator.Length <= 16);
        Assert.Empty(document.Repairs);
        AssertBits([1, 2], document.GetValues(0));
    }

    [Fact]
    public void An_invalid_layout_is_refused()
    {
        Assert.All(["", "\n\n", "x"], static text => Assert.Throws<ArgumentException>(() => new BvhTextFormat { LineEnd = text }));
        Assert.All(["", "\n", ",", new string(' ', 17)], static text => Assert.Throws<ArgumentException>(() => new BvhTextFormat { Separator = text }));
        Assert.All(["\n", "-", new string(' ', 17)], static text => Assert.Throws<ArgumentException>(() => new BvhTextFormat { Indentation = text }));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BvhTextFormat { ValueDecimals = -1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new BvhTextFormat { OffsetDecimals = -1 });
    }

    [Theory]
    [InlineData("1 2 3 4 5 6 7 8 9\n", 0)]
    [InlineData("1.5 2.5 3.5 4.5 5.5 6.5 7.5 8.5 9e1\n", 0)]
    [InlineData("x\n1.5 2.25 3.5 4.5 5.5 6.5 7.5 8.5 9.1\n", 1)]
    [InlineData("1.500 2.500\n1.25 2.25 3.25 4.25 5.25 6.25 7.25 8.25 9.25\n", 2)]
    public void Decimals_follow_the_first_row(string rows, int decimals) => Assert.Equal(decimals, ParseRows(1, rows).TextFormat.ValueDecimals);
}
