using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Running;

/// <summary>The progress of one target. Its own thread writes it. Other threads may read the figures.</summary>
internal sealed class TargetProgress(FuzzTarget target, Corpus corpus, ulong seed, long budget, IReadOnlyList<(string Name, byte[] Bytes)> kept)
{
    // If a parser fails everywhere, not all of its inputs need to be minimised.
    private const int MaxFailingInputs = 8;

    private readonly Mutator _mutator = new(corpus, target.Corpus, seed ^ Digest.Of(System.Text.Encoding.UTF8.GetBytes(target.Name)));
    private readonly List<FailingInput> _failing = [];
    private int _kept;
    private long _inputs;
    private long _bytes;

    public FuzzTarget Target => target;

    public InputRunner Runner { get; } = new(target);

    public long Inputs => Volatile.Read(ref _inputs);

    public long Bytes => Volatile.Read(ref _bytes);

    /// <summary>Time spent. With <see cref="Bytes"/>, it gives the speed.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>One input for each kind of failure, and for each place of an exception. Valid after the run.</summary>
    public IReadOnlyList<FailingInput> FailingInputs => _failing;

    /// <summary>The number of inputs that failed, including repeated failures.</summary>
    public int Failures { get; private set; }

    /// <summary>Whether all kept inputs and unchanged fixtures were read, and then others up to the budget of bytes.</summary>
    public bool IsDone => (Bytes >= budget && _kept == kept.Count && Inputs >= corpus.Fixtures.Count) || _failing.Count == MaxFailingInputs;

    /// <summary>Creates and runs the next input, kept ones first. A failing input is minimised and kept.</summary>
    public void Step()
    {
        if (_kept < kept.Count)
        {
            byte[] input = kept[_kept++].Bytes;
            Explain(Runner.Run(input, isThorough: true), -_kept, input);
            return;
        }

        long number = _inputs;
        ReadOnlySpan<byte> made = _mutator.Make(number);
        FuzzFailure? failure = Runner.Run(made);
        Volatile.Write(ref _inputs, number + 1);
        Volatile.Write(ref _bytes, _bytes + made.Length);
        if (failure is not null)
            Explain(failure, number, made.ToArray());
    }

    /// <summary>Keeps an input that did not end.</summary>
    public void AddOverrun(FuzzFailure failure, byte[] input)
    {
        Failures++;
        _failing.Add(new FailingInput(target.Name, failure, Inputs, input, input));
    }

    private void Explain(FuzzFailure? failure, long number, byte[] input)
    {
        if (failure is null)
            return;

        Failures++;
        if (_failing.Exists(failing => failing.Failure.IsLike(failure)))
            return;

        byte[] smallest = Minimizer.Minimize(input, shorter => failure.IsLike(Runner.Run(shorter, isThorough: true)));
        FuzzFailure shown = Runner.Run(smallest, isThorough: true) ?? failure;
        _failing.Add(new FailingInput(target.Name, shown, number, input, smallest));
    }
}
