using System.Globalization;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Page;

namespace NeuronMocap.Benchmarks.Macro;

// Finds gross regressions in seconds, also on a busy machine: it compares processor times, each with a floor of the same run, and fails only if a ratio is
// three times that of the page.
internal static class Check
{
    public const string Cpu = "CPU ns/frame";

    // The page's table of this command.
    public const string Table = "net8.0-check";

    private const double Tolerance = 3;
    private const int Tries = 3;
    // Runs of a tenth of a second and more: the first one, which does not count, is then long enough to compile the whole path.
    private const int Rounds = 2_000_000;
    private const int Frames = 500_000;
    private const int PerWrite = 32;
    private const int Clients = 4;
    private const int FramesOfClient = 300_000;

    // Without a page, only measures.
    public static async Task<int> RunAsync(int runs, FileInfo? page, Report report)
    {
        IReadOnlyDictionary<(string Case, string Way, string Figure), double>? expected =
            page is null ? null : PageTables.ReadRatios(File.ReadAllText(page.FullName), Table);
        report.Begin($"Processor time of a frame, {runs} runs. A ratio fails that is {Tolerance} times the page's, {Tries} times one after the other.");
        List<string> faults = [];
        foreach ((string name, Way floor, Way[] ways) in Cases())
        {
            List<Row> rows = [];
            List<string> found = [];
            for (int i = 0; i == 0 || (i < Tries && found.Count > 0); i++)
            {
                rows = await Alternation.RunAsync(name, runs, OnlyCpu(floor), [.. ways.Select(OnlyCpu)], []);
                found = expected is null ? [] : FindFaults(rows, expected);
            }

            report.Add(rows);
            faults.AddRange(found);
        }

        foreach (string fault in faults)
            Console.WriteLine(fault);

        report.End();
        return faults.Count == 0 ? 0 : 1;
    }

    private static (string Case, Way Floor, Way[] Ways)[] Cases() =>
    [
        ("no network", Decode.Floor(Rounds), Decode.Ways(Rounds)),
        ("TCP", new Way("raw", () => Throughput.FloorAsync(PerWrite, Frames)), [new Way("callback", () => Throughput.CallbackAsync(PerWrite, Frames))]),
        ("server", new Way("raw", () => Broadcast.RawFloodAsync(Clients, FramesOfClient)), [new Way("flat out", () => Broadcast.FloodAsync(Clients, FramesOfClient))]),
        ("100 avatars", new Way("1 avatar", static () => Scaling.Measure(1, 1, newest: false, Rounds)), [new Way("queue", static () => Scaling.Measure(100, 1, newest: false, Rounds))]),
    ];

    private static List<string> FindFaults(List<Row> rows, IReadOnlyDictionary<(string Case, string Way, string Figure), double> expected)
    {
        List<string> faults = [];
        foreach (Row row in rows.Where(static row => row is { IsFloor: false, Ratio: not null }))
        {
            if (!expected.TryGetValue((row.Case, row.Way, row.Figure), out double ratio))
                faults.Add($"{row.Case}, {row.Way}: the page has no ratio. measure.sh --only check --update writes it.");
            else if (row.Ratio!.Median > Tolerance * ratio)
                faults.Add(string.Create(CultureInfo.InvariantCulture, $"{row.Case}, {row.Way}: {row.Ratio.Median:0.##} times the floor; the page has {ratio:0.##}."));
        }

        return faults;
    }

    private static Way OnlyCpu(Way way) => new(way.Name, async () => new Measurements { [Cpu] = (await way.RunAsync())[Cpu] });
}
