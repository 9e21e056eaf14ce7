using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using NeuronMocap.Benchmarks.Harness;

namespace NeuronMocap.Benchmarks.Page;

// The tables of performance.md. They are between a comment "measured: RESULTS + RESULTS | FIGURE | …" and the comment "end". RESULTS is a file of measure.sh
// without its ending, which has a table of its own, and each figure has a column. A last column says which of these figures miss their aims, if there are aims.
// A table without new results stays.
internal static partial class PageTables
{
    public const string GrowthPicture = "growth.svg";
    public const string RecordingsPicture = "growth-recordings.svg";

    private const string Times = " ×";
    private const string AimsColumn = "aims";

    // Replaces the tables for which there are results.
    public static string Update(string page, Func<string, Results?> read) => Block().Replace(page, match =>
    {
        string[] parts = Split(match.Groups["what"].Value, '|');
        Dictionary<string, string> old = Head().Split(match.Groups["table"].Value).Where(static table => Head().IsMatch(table)).ToDictionary(NameOf, static table => table.TrimEnd('\n') + "\n");
        string[] tables = [.. Split(parts[0], '+').Select(name => read(name) is { } results ? Render(results, parts[1..]) : old.GetValueOrDefault(name)).OfType<string>()];
        return tables.Length == 0 ? match.Value : $"{match.Groups["begin"].Value}\n{string.Join('\n', tables)}{match.Groups["end"].Value}";
    });

    // The medians of the ratios of a table.
    public static IReadOnlyDictionary<(string Case, string Way, string Figure), double> ReadRatios(string page, string name)
    {
        Dictionary<(string, string, string), double> ratios = [];
        Match block = Block().Matches(page).FirstOrDefault(match => Split(match.Groups["what"].Value, '|')[0] == name)
            ?? throw new InvalidOperationException($"The page has no table {name}.");
        string[][] lines = [.. block.Groups["table"].Value.Split('\n').Where(static line => line.StartsWith('|')).Select(static line => Cells(line))];
        string @case = string.Empty;
        foreach (string[] cells in lines.Skip(2))
        {
            @case = cells[0].Length > 0 ? cells[0] : @case;
            for (int i = 2; i < cells.Length; i++)
            {
                if (lines[0][i] != AimsColumn && cells[i].IndexOf(Times, StringComparison.Ordinal) is > 0 and var end)
                    ratios[(@case, cells[1], lines[0][i])] = double.Parse(cells[i][..end], NumberStyles.Number, CultureInfo.InvariantCulture);
            }
        }

        return ratios;
    }

    internal static string Render(Results results, IReadOnlyList<string> figures)
    {
        var text = new StringBuilder();
        text.Append(CultureInfo.InvariantCulture, $"`{results.Command}`, {results.Build}, {results.Runtime}, {results.Processors} × {results.Processor}, {results.System}:\n\n");
        bool hasAims = results.Rows.Any(row => row.Aim is not null && figures.Contains(row.Figure));
        string[] columns = hasAims ? [.. figures, AimsColumn] : [.. figures];
        text.Append(CultureInfo.InvariantCulture, $"| | | {string.Join(" | ", columns)} |\n|---|---|{string.Concat(Enumerable.Repeat("---|", columns.Length))}\n");
        string last = string.Empty;
        foreach (IGrouping<(string Case, string Way), Row> line in results.Rows.GroupBy(static row => (row.Case, row.Way)))
        {
            string[] cells = [.. figures.Select(figure => line.FirstOrDefault(row => row.Figure == figure) is { } row ? Cell(row) : string.Empty)];
            if (Array.TrueForAll(cells, static cell => cell.Length == 0))
                continue;

            string aims = hasAims ? $" {Aims(line, figures)} |" : string.Empty;
            text.Append(CultureInfo.InvariantCulture, $"| {(line.Key.Case == last ? string.Empty : line.Key.Case)} | {line.Key.Way} | {string.Join(" | ", cells)} |{aims}\n");
            last = line.Key.Case;
        }

        if (results.Command == "growth")
            text.Append(CultureInfo.InvariantCulture, $"\n![Cost of a frame as the number grows]({GrowthPicture})\n\n![Time of one call as a recording grows]({RecordingsPicture})\n");

        return text.ToString();
    }

    // The name of the results that a table was made of.
    private static string NameOf(string table)
    {
        string[] head = Split(table, ',');
        return $"{(head[2].StartsWith("Mono", StringComparison.Ordinal) ? "mono" : head[1])}-{head[0].Trim('`')}";
    }

    private static string Aims(IEnumerable<Row> line, IReadOnlyList<string> figures)
    {
        Row[] aimed = [.. line.Where(row => row.Aim is not null && figures.Contains(row.Figure))];
        return string.Join("; ", aimed.GroupBy(static row => row.IsMet == true).OrderBy(static part => part.Key)
            .Select(static part => $"{(part.Key ? "met" : "missed")}: {string.Join(", ", part.Select(Describe))}"));
    }

    // Figure and aim. The value stands between them if the cell does not show it, or not exactly enough.
    private static string Describe(Row row)
    {
        bool isRatio = row.Aim!.EndsWith('×');
        double value = isRatio ? row.Ratio!.Median : row.Value;
        bool isHidden = !isRatio && HasRatio(row);
        bool isClose = row.IsMet == false && Report.Text(value) == Report.Text(double.Parse(row.Aim.Split(' ')[1], CultureInfo.InvariantCulture));
        string shown = isClose ? value.ToString("0.000 ", CultureInfo.InvariantCulture) : isHidden ? Report.Text(value) + " " : string.Empty;
        return $"{row.Figure} {shown}{row.Aim}";
    }

    // Measurements that are read as they are, although the floor has them, too.
    private static bool IsPlain(string figure) => figure.Contains('%') || figure.Contains("B/", StringComparison.Ordinal) || figure is "cores" or "threads" or "lost" or "wake-ups/s";

    private static bool HasRatio(Row row) => row.Ratio is not null && !IsPlain(row.Figure);

    private static string Cell(Row row) => HasRatio(row) && row.Ratio is { } ratio
        ? $"{Report.Text(ratio.Median)}{Times} ({Report.Text(ratio.Low)} to {Report.Text(ratio.High)})"
        : row.Values is { } values && values.Low != values.High ? $"{Report.Text(row.Value)} ({Report.Text(values.Low)} to {Report.Text(values.High)})" : Report.Text(row.Value);

    private static string[] Cells(string line) => Split(line.Trim()[1..^1], '|');

    private static string[] Split(string text, char separator) => [.. text.Split(separator).Select(static part => part.Trim())];

    [GeneratedRegex("(?<begin><!-- measured: (?<what>[^>]*?) -->)\n(?<table>.*?)(?<end><!-- end -->)", RegexOptions.Singleline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Block();

    // The line above a table: command, build, runtime, processors and system.
    [GeneratedRegex("^(?=`[a-z]+`, )", RegexOptions.Multiline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Head();
}
