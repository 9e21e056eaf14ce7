using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Terminal;

/// <summary>A few words that stay together on one line. They may have several styles.</summary>
internal sealed class Piece
{
    private readonly List<Segment> _segments = [];

    public Piece(string text, Style? style = null) => Add(text, style);

    public IReadOnlyList<Segment> Segments => _segments;

    /// <summary>Width in cells.</summary>
    public int Width => Segment.CellCount(_segments);

    public Piece Add(string text, Style? style = null)
    {
        _segments.Add(new Segment(TerminalText.Clean(text), style ?? Style.Plain));
        return this;
    }

    /// <summary>Arranges pieces in as many lines as they need.</summary>
    /// <param name="pieces">The pieces. A piece that is wider than a line is broken between words.</param>
    /// <param name="separator">Separator of two pieces in a line.</param>
    /// <param name="width">Width of a line in cells, at least 1.</param>
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

    /// <summary>Arranges pieces, and adds optional pieces as long as they need no further line.</summary>
    /// <param name="pieces">The pieces.</param>
    /// <param name="optional">Optional pieces, the most important first.</param>
    /// <param name="separator">Separator of two pieces in a line.</param>
    /// <param name="width">Width of a line in cells, at least 1.</param>
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
