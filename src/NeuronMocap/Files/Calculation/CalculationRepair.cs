namespace NeuronMocap.Calculation;

/// <summary>Describes a defect of a calculation export and how it was read.</summary>
/// <param name="Line">Line of the file, from 1.</param>
/// <param name="Column">Byte within that line, from 1.</param>
/// <param name="Description">The defect and its interpretation, in English.</param>
public readonly record struct CalculationRepair(int Line, int Column, string Description)
{
    /// <inheritdoc/>
    public override string ToString() => $"line {Line}, column {Column}: {Description}";
}
