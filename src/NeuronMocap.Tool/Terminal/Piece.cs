using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Terminal;

/// <summary>A few words that stay together on one line. They may have several styles.</summary>
internal sealed class Piece
{
    private readonly List<Segment> _segments = [];

    public Piece(string text, Style? style = null) => Add(text, style);

    public IReadOnlyList<Segment> Segments => _segments;

    /// <summary>Cells that it takes.</summary>
    public int Width => Segment.CellCount(_segments);

    public Piece Add(string text, Style? style = null)
    {
        _segments.Add(new Segment(TerminalText.Clean(text), style ?? Style.Plain));
        return this;
    }

    /// <summary>Lays pieces out in as many lines as they need.</summary>
    /// <param name="pieces">The pieces. One that is wider than a line is broken between its words.</param>
    /// <param name="separator">Stands between two pieces of a line.</param>
    /// <param name="width">Cells of a line, at least 1.</param>
    public static IReadOnlyList<StyledLine> Flow(IEnumerable<Piece> pieces, string separator, int width)
    {
        var lines = new List<StyledLine>();
        int room = 0;
        foreach (Piece piece in pieces.SelectMany(piece => piece.Fit(width)))
        {
            if (lines.Count == 0 || piece.Width + separator.Length > room)
            {
                lines.Add(new StyledLine());
                room = width;
            }
            else
            {
                lines[^1].Add(separator, Palette.DimStyle);
                room -= separator.Length;
            }

            lines[^1].Add(piece);
            room -= piece.Width;
        }

        return lines;
    }

    /// <summary>Lays pieces out, and adds optional ones as long as they need no further line.</summary>
    /// <param name="pieces">The pieces.</param>
    /// <param name="optional">More pieces, the most important first.</param>
    /// <param name="separator">Stands between two pieces of a line.</param>
    /// <param name="width">Cells of a line, at least 1.</param>
    public static IReadOnlyList<StyledLine> Flow(IReadOnlyList<Piece> pieces, IReadOnlyList<Piece> optional, string separator, int width)
    {
        IReadOnlyList<StyledLine> lines = Flow(pieces, separator, width);
        for (int count = 1; count <= optional.Count; count++)
        {
            IReadOnlyList<StyledLine> longer = Flow([.. pieces, .. optional.Take(count)], separator, width);
            if (longer.Count > lines.Count)
                break;

            lines = longer;
        }

        return lines;
    }

    private IEnumerable<Piece> Fit(int width) => Width <= width
        ? [this]
        : _segments.SelectMany(segment => WrappedText.Break(segment.Text, width, int.MaxValue).Select(line => new Piece(line, segment.Style)));
}
