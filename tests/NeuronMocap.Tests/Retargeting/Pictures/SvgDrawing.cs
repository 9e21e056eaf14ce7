using System.Globalization;
using System.Numerics;
using System.Text;
using System.Text.RegularExpressions;

namespace NeuronMocap.Tests.Retargeting.Pictures;

/// <summary>Lines, circles and words as an SVG picture, and a comparison of two such pictures.</summary>
internal sealed partial class SvgDrawing(int width, int height)
{
    // In pixels. Builds may round differently by this much.
    private const double SamePlace = 0.25;

    private readonly StringBuilder _shapes = new();

    public void Line(Vector2 from, Vector2 to, string color, float thickness) => _shapes.Append(Invariant(
        $"<line x1=\"{from.X:0.0}\" y1=\"{from.Y:0.0}\" x2=\"{to.X:0.0}\" y2=\"{to.Y:0.0}\" stroke=\"{color}\" stroke-width=\"{thickness:0.0}\"/>\n"));

    public void Circle(Vector2 center, float radius, string fill, string stroke = "none") => _shapes.Append(Invariant(
        $"<circle cx=\"{center.X:0.0}\" cy=\"{center.Y:0.0}\" r=\"{radius:0.0}\" fill=\"{fill}\" stroke=\"{stroke}\"/>\n"));

    public void Words(Vector2 center, string words, int size = 12, string color = "#444") => _shapes.Append(Invariant(
        $"<text x=\"{center.X:0.0}\" y=\"{center.Y:0.0}\" font-size=\"{size}\" fill=\"{color}\">{words}</text>\n"));

    public override string ToString() => Invariant(
        $"""
        <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" text-anchor="middle" stroke-linecap="round">
        <rect width="{width}" height="{height}" fill="#fff"/>
        {_shapes}</svg>

        """).ReplaceLineEndings("\n");

    /// <summary>Returns the first difference, or null if both show the same.</summary>
    public static string? Difference(string one, string other)
    {
        string[] lines = one.ReplaceLineEndings("\n").Split('\n');
        string[] others = other.ReplaceLineEndings("\n").Split('\n');
        if (lines.Length != others.Length)
            return $"{lines.Length} lines and {others.Length}";

        for (int i = 0; i < lines.Length; i++)
        {
            double[] numbers = Numbers(lines[i]);
            double[] otherNumbers = Numbers(others[i]);
            if (Number().Replace(lines[i], "#") != Number().Replace(others[i], "#")
                || numbers.Zip(otherNumbers, (a, b) => Math.Abs(a - b)).Any(difference => difference > SamePlace))
            {
                return $"line {i + 1}: {lines[i]} and {others[i]}";
            }
        }

        return null;
    }

    private static double[] Numbers(string line) => [.. Number().Matches(line).Select(match => double.Parse(match.Value, CultureInfo.InvariantCulture))];

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);

    // -0.0 is a number, and so is the 1 of x1.
    [GeneratedRegex(@"-?[0-9]+(?:\.[0-9]+)?", RegexOptions.None, matchTimeoutMilliseconds: 10_000)]
    private static partial Regex Number();
}
