namespace NeuronMocap.Bvh;

/// <summary>Describes a defect of a BVH file and how it was read.</summary>
/// <param name="Line">Line of the file, from 1.</param>
/// <param name="Column">Byte within that line, from 1.</param>
/// <param name="Description">The defect and its interpretation, in English.</param>
public readonly record struct BvhRepair(int Line, int Column, string Description)
{
    /// <summary>Whether a row or a line was skipped.</summary>
    public bool SkipsRow { get; init; }

    /// <inheritdoc/>
    public override string ToString() => $"line {Line}, column {Column}: {Description}";
}
