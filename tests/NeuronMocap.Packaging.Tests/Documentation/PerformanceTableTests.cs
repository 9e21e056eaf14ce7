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
