using System.Globalization;
using System.Text;
using NeuronMocap.Benchmarks.Harness;

namespace NeuronMocap.Benchmarks.Page;

// Curves as SVG. Both axes are in powers of ten, so a slope of one decade a decade means proportional growth. The bars are the lowest and the highest run.
internal sealed class LogChart
{
    private const double Width = 720;
    private const double Height = 384;
    private const double Left = 76;
    private const double Right = 590;
    private const double Top = 40;
    private const double Bottom = 320;

    // Bars of two curves at the same place stand side by side.
    private const double Shift = 3;

    // The palette of Okabe and Ito, which nearly everyone can distinguish.
    private static readonly string[] Colors = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"];

    private readonly StringBuilder _svg = new();
    private readonly (double From, double To) _x;
    private readonly (double From, double To) _y;

    private LogChart((double From, double To) x, (double From, double To) y)
    {
        _x = x;
        _y = y;
    }

    public static string Draw(string title, string xTitle, string yTitle, IReadOnlyList<Curve> curves)
    {
        Point[] points = [.. curves.SelectMany(static curve => curve.Points)];
        if (points.Length == 0 || Array.Exists(points, static point => !(point.X > 0 && point.Y.Low > 0)))
            throw new ArgumentException("There must be points, and all their values must be above zero.", nameof(curves));

        var chart = new LogChart(
            PowersAround(points.Min(static point => point.X), points.Max(static point => point.X)),
            PowersAround(points.Min(static point => point.Y.Low), points.Max(static point => point.Y.High)));
        chart.DrawAxes(title, xTitle, yTitle);
        for (int i = 0; i < curves.Count; i++)
            chart.DrawCurve(curves[i], i);

        return chart._svg.Append("</svg>\n").ToString();
    }

    private void DrawAxes(string title, string xTitle, string yTitle)
    {
        _svg.Append(CultureInfo.InvariantCulture, $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {Width} {Height}\" font-family=\"sans-serif\" font-size=\"12\">\n");
        _svg.Append(CultureInfo.InvariantCulture, $"<rect width=\"{Width}\" height=\"{Height}\" fill=\"#ffffff\"/>\n");
        Text(Left, 22, title, "start");
        Text((Left + Right) / 2, Bottom + 44, xTitle, "middle");
        _svg.Append(CultureInfo.InvariantCulture, $"<g transform=\"translate(18,{(Top + Bottom) / 2}) rotate(-90)\">\n");
        Text(0, 0, yTitle, "middle");
        _svg.Append("</g>\n");
        foreach (double tick in Powers(_x))
        {
            Line(X(tick), Top, X(tick), Bottom, "#e7eaee");
            Text(X(tick), Bottom + 18, Label(tick), "middle");
        }

        foreach (double tick in Powers(_y))
        {
            Line(Left, Y(tick), Right, Y(tick), "#e7eaee");
            Text(Left - 8, Y(tick) + 4, Label(tick), "end");
        }
    }

    private void DrawCurve(Curve curve, int index)
    {
        string color = Colors[index % Colors.Length];
        double shift = index * Shift;
        string points = string.Join(' ', curve.Points.Select(point => string.Create(CultureInfo.InvariantCulture, $"{X(point.X) + shift:0.#},{Y(point.Y.Median):0.#}")));
        _svg.Append(CultureInfo.InvariantCulture, $"<polyline points=\"{points}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>\n");
        foreach (Point point in curve.Points)
            Line(X(point.X) + shift, Y(point.Y.Low), X(point.X) + shift, Y(point.Y.High), color);

        Text(Right + 16, Top + 20 + (index * 20), curve.Name, "start", color);
    }

    private double X(double value) => Left + (Position(value, _x) * (Right - Left));

    private double Y(double value) => Bottom - (Position(value, _y) * (Bottom - Top));

    private static double Position(double value, (double From, double To) range) => Math.Log10(value / range.From) / Math.Log10(range.To / range.From);

    private static (double From, double To) PowersAround(double low, double high)
    {
        double from = Math.Floor(Math.Log10(low) + 1e-9);
        return (Math.Pow(10, from), Math.Pow(10, Math.Max(from + 1, Math.Ceiling(Math.Log10(high) - 1e-9))));
    }

    private static IEnumerable<double> Powers((double From, double To) range)
    {
        for (double value = range.From; value <= range.To * 1.0001; value *= 10)
            yield return value;
    }

    private static string Label(double value) => value.ToString(value < 1 ? "0.######" : "#,0", CultureInfo.InvariantCulture);

    private void Line(double x1, double y1, double x2, double y2, string color) => _svg.Append(
        CultureInfo.InvariantCulture, $"<line x1=\"{x1:0.#}\" y1=\"{y1:0.#}\" x2=\"{x2:0.#}\" y2=\"{y2:0.#}\" stroke=\"{color}\"/>\n");

    private void Text(double x, double y, string text, string anchor, string color = "#1f2328") => _svg.Append(
        CultureInfo.InvariantCulture, $"<text x=\"{x:0.#}\" y=\"{y:0.#}\" text-anchor=\"{anchor}\" fill=\"{color}\">{text}</text>\n");

    // Points in the order in which the line connects them.
    internal sealed record Curve(string Name, IReadOnlyList<Point> Points);

    internal sealed record Point(double X, Spread Y);
}
