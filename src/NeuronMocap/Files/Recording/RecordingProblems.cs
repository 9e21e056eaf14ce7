namespace NeuronMocap.Recording;

// The first hundred defects of a file, each listed once.
internal sealed class RecordingProblems
{
    private const int Most = 100;

    private readonly List<RecordingProblem> _all = [];

    public IReadOnlyList<RecordingProblem> All => _all;

    // Callers check this before they describe a defect, because a file may have millions.
    public bool IsFull => _all.Count >= Most;

    public void Add(long offset, long length, string description)
    {
        if (!IsFull && !_all.Exists(problem => problem.Offset == offset && string.Equals(problem.Description, description, StringComparison.Ordinal)))
            _all.Add(new RecordingProblem(offset, length, description));
    }
}
