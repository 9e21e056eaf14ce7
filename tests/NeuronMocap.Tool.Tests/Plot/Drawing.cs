using System.Globalization;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Plot;

/// <summary>A picture created by the verb, and its content.</summary>
internal static partial class Drawing
{
    public static readonly XNamespace Svg = "http://www.w3.org/2000/svg";

    public static async Task<XElement> PlotAsync(TemporaryFolder folder, string name, params string[] options)
    {
        string output = folder[Path.ChangeExtension(name, ".svg")];
        ToolResult result = await ToolRunner.RunAsync(["plot", folder[name], output, .. options]);
        Assert.Empty(result.Error);
        Assert.Equal(0, result.ExitCode);
        return XElement.Load(output);
    }

    public static (double X, double Y)[] Points(XElement svg, string group) =>
    [
        .. svg.Descendants(Svg + "g").Single(element => element.Attribute("id")!.Value == group)
            .Descendants(Svg + "path").SelectMany(static path => PointsOf(path)),
    ];

    public static IEnumerable<(double X, double Y)> PointsOf(XElement path) => Pair().Matches(path.Attribute("d")!.Value)
        .Select(static match => (Parse(match.Groups["x"].Value), Parse(match.Groups["y"].Value)));

    public static void AssertInside(XElement svg)
    {
        Assert.DoesNotContain("NaN", svg.ToString(), StringComparison.Ordinal);
        Assert.DoesNotContain("∞", svg.ToString(), StringComparison.Ordinal);
        foreach (XElement path in svg.Descendants(Svg + "path"))
        {
            Assert.Equal(path.Attribute("d")!.Value.Count(static letter => letter is 'M' or 'L'), PointsOf(path).Count());
            Assert.All(PointsOf(path), static point => AssertInside(point.X, point.Y));
        }

        foreach (XElement element in svg.Descendants())
        {
            foreach (XAttribute attribute in element.Attributes().Where(static attribute => attribute.Name.LocalName is "x" or "x1" or "x2" or "cx"))
                AssertInside(Parse(attribute.Value), 0);
            foreach (XAttribute attribute in element.Attributes().Where(static attribute => attribute.Name.LocalName is "y" or "y1" or "y2" or "cy"))
                AssertInside(0, Parse(attribute.Value));
        }
    }

    private static void AssertInside(double x, double y)
    {
        Assert.InRange(x, 0, 1200);
        Assert.InRange(y, 0, 900);
    }

    public static double Number(XElement element, string name) => Parse(element.Attribute(name)!.Value);

    public static double Parse(string number) => double.Parse(number, NumberStyles.Float, CultureInfo.InvariantCulture);

    [GeneratedRegex("[ML](?<x>-?[0-9.]+) (?<y>-?[0-9.]+)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 10_000)]
    private static partial Regex Pair();
}
