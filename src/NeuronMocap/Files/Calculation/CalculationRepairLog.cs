namespace NeuronMocap.Calculation;

// A file can be wrong on every line; what is told about it stays short. Where reading is strict, the first thing that is wrong ends it.
internal sealed class CalculationRepairLog(bool isStrict)
{
    private readonly List<CalculationRepair> _listed = [];

    public IReadOnlyList<CalculationRepair> Listed => _listed;

    public int Count { get; private set; }

    /// <summary>Rows and lines that were left out.</summary>
    public int LeftOutCount { get; private set; }

    private bool IsFull => _listed.Count == CalculationDocument.MaxListedRepairs;

    /// <summary>Tells of a repair: what was found, a sentence without its full stop, and what was made of it, as its second half.</summary>
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
