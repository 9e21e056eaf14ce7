using System.Globalization;
using NeuronMocap.Benchmarks.Harness;

namespace NeuronMocap.Benchmarks.Page;

// The curves of growth, in two pictures.
internal static class GrowthChart
{
    // The cost of a frame, as the ratio to that of the smallest number.
    public static string DrawCounts(Results results, string figure) => LogChart.Draw(
        "Cost of a frame for each connection, avatar, consumer or client",
        "number",
        "ratio to the cost of one",
        [.. results.Rows.Where(row => row.Figure == figure && (row.IsFloor || row.Ratio is not null)).GroupBy(static row => row.Case)
            .Select(static rows => CurveOf(rows.Key, rows, static row => row.Ratio ?? new Spread(1, 1, 1)))]);

    // The times of the calls of a case, whose ways are lengths.
    public static string DrawRecordings(Results results, string @case) => LogChart.Draw(
        "Time of one call",
        "hours of the recording",
        "milliseconds",
        [.. results.Rows.Where(row => row.Case == @case).GroupBy(static row => row.Figure)
            .Select(static rows => CurveOf(rows.Key.Split(',')[0], rows, InMilliseconds))]);

    private static Spread InMilliseconds(Row row)
    {
        double unit = row.Figure.EndsWith("µs", StringComparison.Ordinal) ? 0.001 : 1;
        return new Spread(row.Values!.Low * unit, row.Values.Median * unit, row.Values.High * unit);
    }

    private static LogChart.Curve CurveOf(string name, IEnumerable<Row> rows, Func<Row, Spread> value) =>
        new(name, [.. rows.Select(row => new LogChart.Point(NumberOf(row.Way), value(row))).OrderBy(static point => point.X)]);

    // The number that a way starts with, without its unit.
    private static double NumberOf(string way) => double.Parse(way.Split(' ')[0], CultureInfo.InvariantCulture);
}
