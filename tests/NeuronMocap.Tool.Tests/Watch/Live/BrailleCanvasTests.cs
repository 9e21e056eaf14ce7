using NeuronMocap.Tool.Watch.Live;
using Spectre.Console;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class BrailleCanvasTests
{
    [Theory]
    [InlineData(0, 0, '⠁')]
    [InlineData(0, 1, '⠂')]
    [InlineData(0, 2, '⠄')]
    [InlineData(0, 3, '⡀')]
    [InlineData(1, 0, '⠈')]
    [InlineData(1, 1, '⠐')]
    [InlineData(1, 2, '⠠')]
    [InlineData(1, 3, '⢀')]
    public void Dots_match_the_Braille_patterns(int x, int y, char expected)
    {
        var canvas = new BrailleCanvas(1, 1);
        canvas.Set(x, y, Color.White);
        Assert.Equal($"{expected}", canvas.GetRow(0));
    }

    [Fact]
    public void Lines_are_whole_and_include_both_ends()
    {
        var canvas = new BrailleCanvas(3, 2);
        canvas.DrawLine(0, 3, 5, 3, Color.White);
        canvas.DrawLine(0, 0, 0, 7, Color.White);
        Assert.Equal(["⣇⣀⣀", "⡇⠀⠀"], [canvas.GetRow(0), canvas.GetRow(1)]);
    }

    [Fact]
    public void A_diagonal_goes_through_both_corners()
    {
        var canvas = new BrailleCanvas(2, 1);
        canvas.DrawLine(0, 0, 3, 3, Color.White);
        Assert.Equal("⠑⢄", canvas.GetRow(0));
    }

    [Theory]
    [InlineData(-5, -5, -1, -1)]
    [InlineData(float.NaN, 0, 1, 1)]
    [InlineData(0, float.NegativeInfinity, 1, 1)]
    public void Points_outside_leave_no_dot(float x0, float y0, float x1, float y1)
    {
        var canvas = new BrailleCanvas(2, 1);
        canvas.DrawLine(x0, y0, x1, y1, Color.White);
        canvas.DrawCircle(x0, y0, x1, Color.White);
        Assert.Equal("⠀⠀", canvas.GetRow(0));
    }

    [Fact]
    public void Text_is_cut_at_the_edge()
    {
        var canvas = new BrailleCanvas(4, 1);
        canvas.Write(2, 0, "side", Color.White);
        canvas.Write(0, 5, "below", Color.White);
        Assert.Equal("⠀⠀si", canvas.GetRow(0));
    }

    [Fact]
    public void An_empty_canvas_accepts_everything()
    {
        var canvas = new BrailleCanvas(-1, 0);
        canvas.DrawLine(0, 0, 10, 10, Color.White);
        Assert.Equal((0, 0), (canvas.Width, canvas.Height));
    }
}
