using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Running;

/// <summary>How far one target has come. Written by the thread that runs it; the figures may be read by others.</summary>
internal sealed class TargetProgress(FuzzTarget target, Corpus corpus, ulong seed, long budget, IReadOnlyList<(string Name, byte[] Bytes)> kept)
{
    // A parser that is wrong about everything need not be made small for all of it.
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

    /// <summary>Time spent, of which <see cref="Bytes"/> give a speed.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>One for each kind of failure, and for each place of an exception. Once the run is over.</summary>
    public IReadOnlyList<FailingInput> FailingInputs => _failing;

    /// <summary>Inputs that failed, also those that failed like one before.</summary>
    public int Failures { get; private set; }

    /// <summary>Every input that was kept and every fixture as it is were read, and then as many others as there are bytes for.</summary>
    public bool IsDone => (Bytes >= budget && _kept == kept.Count && Inputs >= corpus.Fixtures.Count) || _failing.Count == MaxFailingInputs;

    /// <summary>Makes and runs the next input, first those that were kept; a failure is made small and kept.</summary>
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

    /// <summary>Keeps an input that did not come to an end.</summary>
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
