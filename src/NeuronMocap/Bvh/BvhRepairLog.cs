namespace NeuronMocap.Bvh;

// A file can be wrong on every line; what is told about it stays short.
internal sealed class BvhRepairLog
{
    private readonly List<BvhRepair> _listed = [];

    public IReadOnlyList<BvhRepair> Listed => _listed;

    public int Count { get; private set; }

    public void Add(int line, string description)
    {
        Count++;
        if (_listed.Count < BvhDocument.MaxListedRepairs)
            _listed.Add(new BvhRepair(line, description));
    }
}
