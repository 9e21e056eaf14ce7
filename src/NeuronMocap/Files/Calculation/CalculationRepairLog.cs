namespace NeuronMocap.Calculation;

// Collects repairs. A file can be wrong on every line; the list therefore has a limit. A strict log throws at the first defect.
internal sealed class CalculationRepairLog(bool isStrict)
{
    private readonly List<CalculationRepair> _listed = [];

    public IReadOnlyList<CalculationRepair> Listed => _listed;

    public int Count { get; private set; }

    /// <summary>Number of rows and lines that were skipped.</summary>
    public int LeftOutCount { get; private set; }

    private bool IsFull => _listed.Count == CalculationDocument.MaxListedRepairs;

    /// <summary>Adds a repair: the defect, a sentence without its full stop, and its interpretation, the second half of the sentence.</summary>
    public void Add(int line, int column, string found, string made, bool isLeftOut = false)
    {
        if (isStrict)
            throw new CalculationFormatException($"{found}.", line, column);

        Count += Count < int.MaxValue ? 1 : 0;
        LeftOutCount += isLeftOut && LeftOutCount < int.MaxValue ? 1 : 0;
        if (!IsFull)
            _listed.Add(new CalculationRepair(line, column, $"{found}; {made}."));
    }
}
