using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Terminal;

/// <summary>A line of text with optional text at the right edge. Text that does not fit is cut off, starting with the left part.</summary>
internal sealed class StyledLine : Renderable
{
    private readonly List<Segment> _left = [];
    private readonly List<Segment> _right = [];
    private readonly List<Segment> _colouredRight = [];

    public StyledLine Add(string text, Style? style = null)
    {
        _left.Add(new Segment(TerminalText.Clean(text), style ?? Style.Plain));
        return this;
    }

    public StyledLine Add(Piece piece)
    {
        _left.AddRange(piece.Segments);
        return this;
    }

    public StyledLine AddRight(string text, Style? style = null)
    {
        _right.Add(new Segment(TerminalText.Clean(text), style ?? Style.Plain));
        return this;
    }

    public StyledLine AddRight(Piece piece)
    {
        _right.AddRange(piece.Segments);
        return this;
    }

    /// <summary>Adds text whose meaning is only its colour. A terminal without colours does not show it.</summary>
    public StyledLine AddColouredRight(string text, Style style)
    {
        _colouredRight.Add(new Segment(TerminalText.Clean(text), style));
        return this;
    }

    protected override Measurement Measure(RenderOptions options, int maxWidth) => new(maxWidth, maxWidth);

    protected override IEnumerable<Segment> Render(RenderOptions options, int maxWidth)
    {
        List<Segment> right = CutOff(options.ColorSystem == ColorSystem.NoColors ? _right : [.. _right, .. _colouredRight], maxWidth);
        int room = maxWidth - Segment.CellCount(right);
        List<Segment> left = CutOff(_left, right.Count > 0 ? room - 1 : room);
        return [.. left, Segment.Padding(room - Segment.CellCount(left)), .. right, Segment.LineBreak];
    }

    private static List<Segment> CutOff(List<Segment> segments, int width)
    {
        if (Segment.CellCount(segments) <= width)
            return segments;
        if (width <= 0)
            return [];

        var cut = new List<Segment>();
        int room = width - 1;
        foreach (Segment segment in segments)
        {
            string text = segment.Text;
            while (new Segment(text).CellCount() > room)
                text = text[..^1];

            cut.Add(new Segment(text, segment.Style));
            room -= cut[^1].CellCount();
            if (text.Length < segment.Text.Length)
                break;
        }

        return [.. cut, new Segment("…", cut[^1].Style)];
    }
}
