namespace NeuronMocap.Benchmarks.Harness;

// One of the alternatives that are measured in turn. A run returns figures by name.
internal sealed record Way(string Name, Func<Task<Measurements>> RunAsync)
{
    public Way(string name, Func<Measurements> run)
        : this(name, () => Task.FromResult(run()))
    {
    }
}

// The figures of one run: name with unit, and value.
internal sealed class Measurements : Dictionary<string, double>;

// The limit for a figure: absolute, or as a ratio to the floor's figure of the same name.
internal sealed record Aim(string Figure, double Limit, bool IsRatio = false, bool IsLowerBound = false, string? Way = null)
{
    public bool IsMetBy(double value) => IsLowerBound ? value >= Limit : value <= Limit;

    public override string ToString() => FormattableString.Invariant($"{(IsLowerBound ? "≥" : "≤")} {Limit:0.##}{(IsRatio ? " ×" : string.Empty)}");
}
