using System.Globalization;
using System.Text;
using NeuronMocap.Benchmarks.Harness;

namespace NeuronMocap.Benchmarks.Page;

// The curves of growth as SVG: a line for each case, from the smallest number to the largest, with both axes in powers of ten. The bars are the lowest and
// the highest run.
internal static class GrowthChart
{
    private const double Width = 720;
    private const double Height = 360;
    private const double Left = 56;
    private const double Right = 590;
    private const double Top = 40;
    private const double Bottom = 312;
    private const double LeastRatio = 0.01;
    private const double MostRatio = 10;

    // The palette of Okabe and Ito, which nearly everyone can distinguish.
    private static readonly string[] Colors = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"];

    public static string Draw(Results results, string figure)
    {
        var svg = new StringBuilder();
        svg.Append(CultureInfo.InvariantCulture, $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {Width} {Height}\" font-family=\"sans-serif\" font-size=\"12\">\n");
        svg.Append(CultureInfo.InvariantCulture, $"<rect width=\"{Width}\" height=\"{Height}\" fill=\"#ffffff\"/>\n");
        Text(svg, Left, 22, "Cost of a frame for each connection, avatar, consumer or client, as a ratio to one", "start");
        IGrouping<string, Row>[] lines = [.. results.Rows.Where(row => row.Figure == figure).GroupBy(static row => row.Case)];
        double most = Math.Max(10, lines.SelectMany(static line => line).Max(static row => Number(row.Way)));
        foreach (double tick in Powers(1, most))
        {
            Line(svg, X(tick), Top, X(tick), Bottom, "#e7eaee");
            Text(svg, X(tick), Bottom + 18, tick.ToString("#,0", CultureInfo.InvariantCulture), "middle");
        }

        foreach (double tick in Powers(LeastRatio, MostRatio))
        {
            Line(svg, Left, Y(tick), Right, Y(tick), tick == 1 ? "#9aa2ab" : "#e7eaee");
            Text(svg, Left - 8, Y(tick) + 4, tick.ToString("0.##", CultureInfo.InvariantCulture), "end");
        }

        foreach ((IGrouping<string, Row> line, int i) in lines.Select(static (line, i) => (line, i)))
            Curve(svg, line, Colors[i % Colors.Length], i);

        return svg.Append("</svg>\n").ToString();

        void Curve(StringBuilder svg, IGrouping<string, Row> line, string color, int index)
        {
            Row[] rows = [.. line.OrderBy(static row => Number(row.Way))];
            string points = string.Join(' ', rows.Select(row => string.Create(CultureInfo.InvariantCulture, $"{X(Number(row.Way)):0.#},{Y(row.Ratio?.Median ?? 1):0.#}")));
            svg.Append(CultureInfo.InvariantCulture, $"<polyline points=\"{points}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>\n");
            foreach (Row row in rows)
            {
                double x = X(Number(row.Way)) + (index * 3);
                if (row.Ratio is { } ratio)
                    Line(svg, x, Y(ratio.Low), x, Y(ratio.High), color);
            }

            Text(svg, Right + 12, Top + 20 + (index * 20), line.Key, "start", color);
        }

        double X(double count) => Left + (Math.Log10(count) / Math.Log10(most) * (Right - Left));
    }

    private static double Y(double ratio) =>
        Bottom - (Math.Log10(Math.Clamp(ratio, LeastRatio, MostRatio) / LeastRatio) / Math.Log10(MostRatio / LeastRatio) * (Bottom - Top));

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private static IEnumerable<double> Powers(double from, double to)
    {
        for (double value = from; value <= to * 1.0001; value *= 10)
            yield return value;
    }

    private static void Line(StringBuilder svg, double x1, double y1, double x2, double y2, string color) => svg.Append(
        CultureInfo.InvariantCulture, $"<line x1=\"{x1:0.#}\" y1=\"{y1:0.#}\" x2=\"{x2:0.#}\" y2=\"{y2:0.#}\" stroke=\"{color}\"/>\n");

    private static void Text(StringBuilder svg, double x, double y, string text, string anchor, string color = "#1f2328") => svg.Append(
        CultureInfo.InvariantCulture, $"<text x=\"{x:0.#}\" y=\"{y:0.#}\" text-anchor=\"{anchor}\" fill=\"{color}\">{text}</text>\n");
}
