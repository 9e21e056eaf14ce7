namespace NeuronMocap.Benchmarks.Harness;

// A figure of one way over all runs: medians, and the ratio to the floor run by run.
internal sealed record Row(string Case, string Way, string Figure, double Value, double? Floor, Spread? Ratio, string? Aim, bool? IsMet)
{
    // Of the values. Their median is Value.
    public Spread? Values { get; init; }

    // Whether this is the floor itself.
    public bool IsFloor { get; init; }

    public static Row OfFloor(string @case, string way, string figure, double[] values) =>
        new(@case, way, figure, Spread.Of(values).Median, null, null, null, null) { Values = Spread.Of(values), IsFloor = true };

    public static Row From(string @case, string way, string figure, double[] values, double[]? floors, IReadOnlyList<Aim> aims)
    {
        Spread? ratio = floors is null || Array.Exists(floors, static floor => floor == 0)
            ? null
            : Spread.Of([.. values.Zip(floors, static (value, floor) => value / floor)]);
        double value = Spread.Of(values).Median;
        Aim? aim = aims.FirstOrDefault(aim => aim.Figure == figure && (aim.Way ?? way) == way);
        return new Row(
            @case, way, figure, value, floors is null ? null : Spread.Of(floors).Median, ratio, aim?.ToString(), aim?.IsMetBy(aim.IsRatio ? ratio!.Median : value))
        {
            Values = Spread.Of(values),
        };
    }
}

internal sealed record Spread(double Low, double Median, double High)
{
    public static Spread Of(double[] values)
    {
        double[] sorted = [.. values.Order()];
        return new Spread(sorted[0], Percentile(sorted, 0.5), sorted[^1]);
    }

    public static double Percentile(double[] sorted, double part) => sorted[(int)Math.Min(sorted.Length - 1, sorted.Length * part)];
}
