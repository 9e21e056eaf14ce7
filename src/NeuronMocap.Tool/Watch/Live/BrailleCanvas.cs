using System.Text;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>A drawing of dots.</summary>
/// <remarks>
/// A character cell holds 2 by 4 dots, which makes them roughly square in most terminals. A cell has one colour: the last colour that was drawn in
/// it.
/// </remarks>
internal sealed class BrailleCanvas : Renderable
{
    public const int DotsPerColumn = 2;
    public const int DotsPerRow = 4;

    private const char Blank = '\u2800';

    private readonly char[] _cells;
    private readonly Color[] _colors;

    public BrailleCanvas(int columns, int rows)
    {
        Columns = Math.Max(columns, 0);
        Rows = Math.Max(rows, 0);
        _cells = new char[Columns * Rows];
        _colors = new Color[Columns * Rows];
        Array.Fill(_cells, Blank);
    }

    public int Columns { get; }

    public int Rows { get; }

    public int Width => Columns * DotsPerColumn;

    public int Height => Rows * DotsPerRow;

    /// <summary>Gets the column of a dot.</summary>
    public static int ColumnOf(float x) => Round(x) / DotsPerColumn;

    /// <summary>Gets the row of a dot.</summary>
    public static int RowOf(float y) => Round(y) / DotsPerRow;

    /// <summary>Sets a dot. Dots outside the canvas are ignored.</summary>
    /// <param name="x">Dots from the left.</param>
    /// <param name="y">Dots from the top.</param>
    /// <param name="color">The colour of the cell.</param>
    public void Set(int x, int y, Color color)
    {
        if (x < 0 || x >= Width || y < 0 || y >= Height)
            return;

        int cell = (y / DotsPerRow * Columns) + (x / DotsPerColumn);
        char old = _cells[cell] >= Blank && _cells[cell] <= Blank + 0xFF ? _cells[cell] : Blank;
        _cells[cell] = (char)(old | DotBit(x % DotsPerColumn, y % DotsPerRow));
        _colors[cell] = color;
    }

    /// <summary>Draws a line of dots, including both ends.</summary>
    public void DrawLine(float x0, float y0, float x1, float y1, Color color)
    {
        float longest = Math.Max(Math.Abs(x1 - x0), Math.Abs(y1 - y0));
        if (!float.IsFinite(longest))
            return;

        // A broken pose may have any size. Dots far outside must not take time.
        int steps = (int)Math.Min(MathF.Ceiling(longest), 4 * (Width + Height));
        for (int i = 0; i <= steps; i++)
        {
            float t = steps == 0 ? 0 : i / (float)steps;
            Set(Round(x0 + ((x1 - x0) * t)), Round(y0 + ((y1 - y0) * t)), color);
        }
    }

    /// <summary>Draws a circle of dots.</summary>
    public void DrawCircle(float x, float y, float radius, Color color)
    {
        if (!float.IsFinite(x + y + radius))
            return;

        int steps = (int)Math.Clamp(MathF.Ceiling(radius * MathF.Tau), 8, 4 * (Width + Height + 2));
        for (int i = 0; i < steps; i++)
        {
            (float sin, float cos) = MathF.SinCos(MathF.Tau * i / steps);
            Set(Round(x + (radius * cos)), Round(y + (radius * sin)), color);
        }
    }

    /// <summary>Writes text over the dots. Text that does not fit is cut off.</summary>
    public void Write(int column, int row, string text, Color color)
    {
        for (int i = 0; i < text.Length && column + i < Columns; i++)
        {
            if (column + i < 0 || row < 0 || row >= Rows)
                continue;

            _cells[(row * Columns) + column + i] = text[i];
            _colors[(row * Columns) + column + i] = color;
        }
    }

    /// <summary>Gets a row of characters.</summary>
    public string GetRow(int row) => new(_cells, row * Columns, Columns);

    protected override Measurement Measure(RenderOptions options, int maxWidth)
    {
        int columns = Math.Min(Columns, maxWidth);
        return new Measurement(columns, columns);
    }

    protected override IEnumerable<Segment> Render(RenderOptions options, int maxWidth)
    {
        int columns = Math.Min(Columns, maxWidth);
        var text = new StringBuilder();
        for (int row = 0; row < Rows; row++)
        {
            int first = row * Columns;
            for (int cell = first; cell < first + columns; cell++)
            {
                text.Append(_cells[cell] == Blank ? ' ' : _cells[cell]);
                if (cell + 1 < first + columns && _colors[cell + 1] == _colors[cell])
                    continue;

                yield return new Segment(text.ToString(), new Style(_colors[cell]));
                text.Clear();
            }

            yield return Segment.LineBreak;
        }
    }

    private static int Round(float value) => (int)Math.Clamp(MathF.Round(value), -1_000_000, 1_000_000);

    // Unicode numbers the dots down the left column, then down the right one, and the lowest two last.
    private static int DotBit(int x, int y) => y == 3 ? 0x40 << x : 1 << (y + (3 * x));
}
