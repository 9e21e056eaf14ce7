namespace NeuronMocap.Benchmarks.Harness;

// Runs the floor and the ways in turn, A B C A B C. Other load on the machine thus affects all of them equally.
internal static class Alternation
{
    public static async Task<List<Row>> RunAsync(string @case, int runs, Way floor, IReadOnlyList<Way> ways, IReadOnlyList<Aim> aims)
    {
        List<Measurements> floors = [];
        List<Measurements>[] results = [.. ways.Select(static _ => new List<Measurements>())];

        // The first round is a warm-up and does not count.
        for (int run = 0; run <= runs; run++)
        {
            await MeasureAsync(floor, run, floors);
            for (int way = 0; way < ways.Count; way++)
                await MeasureAsync(ways[way], run, results[way]);
        }

        List<Row> rows = [.. floors[0].Keys.Select(figure => Row.OfFloor(@case, floor.Name, figure, Pick(floors, figure)))];
        for (int way = 0; way < ways.Count; way++)
        {
            foreach (string figure in results[way][0].Keys)
            {
                double[]? basis = floors[0].ContainsKey(figure) ? Pick(floors, figure) : null;
                rows.Add(Row.From(@case, ways[way].Name, figure, Pick(results[way], figure), basis, aims));
            }
        }

        return rows;
    }

    private static async Task MeasureAsync(Way way, int run, List<Measurements> results)
    {
        // Keeps garbage of an earlier run from being collected during this one.
        GC.Collect();
        GC.WaitForPendingFinalizers();
        Measurements figures = await way.RunAsync();
        if (run > 0)
            results.Add(figures);
    }

    private static double[] Pick(List<Measurements> results, string figure) => [.. results.Select(figures => figures[figure])];
}
