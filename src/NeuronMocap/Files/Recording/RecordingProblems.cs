namespace NeuronMocap.Recording;

// What was found wrong with a file: the first hundred, each once.
internal sealed class RecordingProblems
{
    private const int Most = 100;

    private readonly List<RecordingProblem> _all = [];

    public IReadOnlyList<RecordingProblem> All => _all;

    // Whoever describes what is wrong with millions of blocks looks here before.
    public bool IsFull => _all.Count >= Most;

    public void Add(long offset, long length, string description)
    {
        if (!IsFull && !_all.Exists(problem => problem.Offset == offset && string.Equals(problem.Description, description, StringComparison.Ordinal)))
            _all.Add(new RecordingProblem(offset, length, description));
    }
}
