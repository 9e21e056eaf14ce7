namespace NeuronMocap.Bvh;

/// <summary>Something that was wrong in a BVH file, and how it was read all the same.</summary>
/// <param name="Line">Line of the file, from 1.</param>
/// <param name="Column">Byte of that line, from 1.</param>
/// <param name="Description">What was found and what was made of it, in English.</param>
public readonly record struct BvhRepair(int Line, int Column, string Description)
{
    /// <inheritdoc/>
    public override string ToString() => $"line {Line}, column {Column}: {Description}";
}
