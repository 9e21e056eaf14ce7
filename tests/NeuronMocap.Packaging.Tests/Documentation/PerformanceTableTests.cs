using System.Globalization;
using System.Xml.Linq;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Page;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>The tables of performance.md that the benchmarks write, and that the check for regressions reads.</summary>
public sealed class PerformanceTableTests
{
    private const string Page = """
        Before.

        <!-- measured: net8.0-decode + mono-decode | ns/frame | lost -->
        <!-- end -->

        After.
        """;

    private static readonly XNamespace Svg = "http://www.w3.org/2000/svg";

    private static readonly Results Net = ResultsOf("net8.0", ".NET 10.0", ratio: 2.5);
    private static readonly Results Mono = ResultsOf("netstandard2.0", "Mono 6.8", ratio: 4);

    [Fact]
    public void Both_builds_get_a_table()
    {
        string page = PageTables.Update(Page, static name => name == "mono-decode" ? Mono : Net);
        Assert.Contains("`decode`, net8.0, .NET 10.0, 2 × One, Linux:", page, StringComparison.Ordinal);
        Assert.Contains("| one frame | copy | 10.0 (9.00 to 11.0) |  |", page, StringComparison.Ordinal);
        Assert.Contains("|  | queue | 2.50 × (2.00 to 3.00) | 0 |", page, StringComparison.Ordinal);
        Assert.Contains("|  | queue | 4.00 × (2.00 to 3.00) | 0 |", page, StringComparison.Ordinal);
        Assert.StartsWith("Before.\n\n<!-- measured", page, StringComparison.Ordinal);
        Assert.EndsWith("<!-- end -->\n\nAfter.", page, StringComparison.Ordinal);
    }

    [Fact]
    public void A_build_that_was_not_measured_again_keeps_its_table()
    {
        string both = PageTables.Update(Page, static name => name == "mono-decode" ? Mono : Net);
        Assert.Equal(both, PageTables.Update(both, static name => name == "net8.0-decode" ? Net : null));
        Assert.Equal(both, PageTables.Update(both, static name => name == "mono-decode" ? Mono : null));
        Assert.Equal(both, PageTables.Update(both, static _ => null));

        string onlyMono = PageTables.Update(Page, static name => name == "mono-decode" ? Mono : null);
        Assert.DoesNotContain("net8.0, .NET", onlyMono, StringComparison.Ordinal);
        Assert.Equal(both, PageTables.Update(onlyMono, static name => name == "net8.0-decode" ? Net : null));
    }

    [Fact]
    public void The_check_reads_the_ratios_that_were_written()
    {
        string page = PageTables.Update(Page, static name => name == "net8.0-decode" ? Net : null).Replace("net8.0-decode + mono-decode", "net8.0-decode", StringComparison.Ordinal);
        KeyValuePair<(string, string, string), double> ratio = Assert.Single(PageTables.ReadRatios(page, "net8.0-decode"));
        Assert.Equal((("one frame", "queue", "ns/frame"), 2.5), (ratio.Key, ratio.Value));
        Assert.Throws<InvalidOperationException>(() => PageTables.ReadRatios(page, "net8.0-other"));
    }

    [Fact]
    public void The_last_column_names_the_aims_that_are_missed()
    {
        const string Aimed = "<!-- measured: net8.0-decode | ns/frame | B/frame -->\n<!-- end -->";
        Row[] rows =
        [
            new Row("one frame", "copy", "ns/frame", 10, null, null, null, null) { Values = new Spread(9, 10, 11), IsFloor = true },
            .. Cells("callback", (true, true)),
            .. Cells("queue", (false, true)),
            .. Cells("newest", (false, false)),
            new Row("one frame", "newest", "hidden", 1, null, null, "≤ 0", IsMet: false),
        ];
        string page = PageTables.Update(Aimed, _ => Net with { Rows = rows });
        Assert.Contains("| | | ns/frame | B/frame | aims |\n|---|---|---|---|---|\n", page, StringComparison.Ordinal);
        Assert.Contains("| one frame | copy | 10.0 (9.00 to 11.0) |  |  |\n", page, StringComparison.Ordinal);
        Assert.Contains("|  | callback | 2.50 × (2.00 to 3.00) | 1.00 | met: ns/frame ≤ 2 ×, B/frame ≤ 0 |\n", page, StringComparison.Ordinal);
        Assert.Contains("|  | queue | 2.50 × (2.00 to 3.00) | 1.00 | missed: ns/frame ≤ 2 ×; met: B/frame ≤ 0 |\n", page, StringComparison.Ordinal);
        Assert.Contains("|  | newest | 2.50 × (2.00 to 3.00) | 1.00 | missed: ns/frame ≤ 2 ×, B/frame ≤ 0 |\n", page, StringComparison.Ordinal);
        Assert.Equal(new[] { 2.5, 2.5, 2.5 }, PageTables.ReadRatios(page, "net8.0-decode").Values);

        static Row[] Cells(string way, (bool Time, bool Bytes) met) =>
        [
            new Row("one frame", way, "ns/frame", 25, 10, new Spread(2, 2.5, 3), "≤ 2 ×", met.Time),
            new Row("one frame", way, "B/frame", 1, null, null, "≤ 0", met.Bytes) { Values = new Spread(1, 1, 1) },
        ];
    }

    [Fact]
    public void An_aim_has_the_value_where_the_cell_does_not_show_it()
    {
        Row[] rows =
        [
            new Row("one frame", "copy", "ns/frame", 10, null, null, null, null) { Values = new Spread(9, 10, 11), IsFloor = true },
            new Row("one frame", "queue", "ns/frame", 8.54, 10, new Spread(0.7, 0.8473, 0.9), "≥ 0.85 ×", IsMet: false),
            new Row("one frame", "newest", "ns/frame", 8.54, 10, new Spread(0.7, 0.8473, 0.9), "≤ 20", IsMet: true),
        ];
        string page = PageTables.Update(Page, name => name == "net8.0-decode" ? Net with { Rows = rows } : null);
        Assert.Contains("missed: ns/frame 0.847 ≥ 0.85 × |", page, StringComparison.Ordinal);
        Assert.Contains("met: ns/frame 8.54 ≤ 20 |", page, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0.001234, "0.001234")]
    [InlineData(0.0000001, "0")]
    [InlineData(0.01, "0.01")]
    [InlineData(0.996, "1.00")]
    [InlineData(12.34, "12.3")]
    [InlineData(123456, "123,456")]
    public void Small_figures_are_not_written_as_zero(double value, string text) => Assert.Equal(text, Report.Text(value));

    [Fact]
    public void What_is_not_above_zero_cannot_be_drawn()
    {
        Row zero = new("recordings", "1 h", "open, µs", 0, null, null, null, null) { Values = new Spread(0, 0, 1) };
        Assert.Throws<ArgumentException>(() => GrowthChart.DrawRecordings(Net with { Rows = [zero] }, "recordings"));
        Assert.Throws<ArgumentException>(() => GrowthChart.DrawRecordings(Net, "recordings"));
    }

    [Fact]
    public void Growth_is_drawn_as_curves()
    {
        (string Case, string Way, double Ratio)[] measured = [("clients", "1", 0), ("clients", "1000", 0.3), ("clients", "10", 0.2), ("avatars", "1", 0), ("avatars", "10", 1.1)];
        Row[] counts = [.. measured.Select(static row => new Row(row.Case, row.Way, "CPU ns/frame", 5, null, row.Ratio > 0 ? new Spread(row.Ratio / 2, row.Ratio, row.Ratio * 2) : null, null, null) { IsFloor = row.Ratio == 0 })];
        Row[] recordings = [.. from figure in new[] { "open, µs", "info, ms" } from hours in new[] { "0.1 h", "1 h", "10 h" }
            select new Row("recordings", hours, figure, 0, null, null, null, null) { Values = new Spread(20, 50, 400) }];
        var results = Net with { Rows = [.. counts, .. recordings] };

        XElement ratios = XElement.Parse(GrowthChart.DrawCounts(results, "CPU ns/frame"));
        Assert.Equal(["clients: 3", "avatars: 2"], Curves(ratios));
        Assert.Equal(["1", "10", "100", "1,000"], Ticks(ratios, "middle"));
        Assert.Equal(["0.1", "1", "10"], Ticks(ratios, "end"));

        XElement times = XElement.Parse(GrowthChart.DrawRecordings(results, "recordings"));
        Assert.Equal(["open: 3", "info: 3"], Curves(times));
        Assert.Equal(["0.01", "0.1", "1", "10", "100", "1,000"], Ticks(times, "end"));
    }

    private static string[] Ticks(XElement svg, string anchor) =>
        [.. svg.Descendants(Svg + "text").Where(text => text.Attribute("text-anchor")!.Value == anchor && char.IsDigit(text.Value[0])).Select(static text => text.Value)];

    // Each curve's name and number of points. The points are from left to right.
    private static string[] Curves(XElement svg) => [.. svg.Descendants(Svg + "polyline").Select(line =>
    {
        double[] places = [.. line.Attribute("points")!.Value.Split(' ').Select(static point => double.Parse(point.Split(',')[0], CultureInfo.InvariantCulture))];
        Assert.Equal(places.Order(), places);
        string color = line.Attribute("stroke")!.Value;
        return $"{svg.Descendants(Svg + "text").Single(text => text.Attribute("fill")!.Value == color).Value}: {places.Length}";
    })];

    // A ratio of a table with noise in it would let a regression of many times pass.
    [Fact]
    public void The_page_has_the_ratios_of_the_check()
    {
        IReadOnlyDictionary<(string Case, string Way, string Figure), double> ratios =
            PageTables.ReadRatios(File.ReadAllText(Repository.PathOf("docs", "internals", "performance.md")), "net8.0-check");
        Assert.Equal(
            ["100 avatars, queue", "TCP, callback", "no network, callback", "no network, newest", "no network, queue", "server, flat out"],
            ratios.Keys.Select(static key => $"{key.Case}, {key.Way}").Order(StringComparer.Ordinal));
        Assert.All(ratios.Values, static ratio => Assert.InRange(ratio, 0.5, 8));
    }

    private static Results ResultsOf(string build, string runtime, double ratio) => new("decode", build, 2, "One", "Linux", runtime,
    [
        new Row("one frame", "copy", "ns/frame", 10, null, null, null, null) { Values = new Spread(9, 10, 11), IsFloor = true },
        new Row("one frame", "queue", "ns/frame", 25, 10, new Spread(2, ratio, 3), null, null) { Values = new Spread(20, 25, 30) },
        new Row("one frame", "queue", "lost", 0, null, null, null, null) { Values = new Spread(0, 0, 0) },
    ]);
}
