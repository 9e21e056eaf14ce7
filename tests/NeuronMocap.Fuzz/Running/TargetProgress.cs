using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Running;

/// <summary>How far one target has come. Written by the thread that runs it; the figures may be read by others.</summary>
internal sealed class TargetProgress(FuzzTarget target, Corpus corpus, ulong seed, long budget)
{
    private readonly Mutator _mutator = new(corpus, seed ^ Digest.Of(System.Text.Encoding.UTF8.GetBytes(target.Name)));
    private long _inputs;
    private long _bytes;

    public FuzzTarget Target => target;

    public InputRunner Runner { get; } = new(target);

    public long Inputs => Volatile.Read(ref _inputs);

    public long Bytes => Volatile.Read(ref _bytes);

    /// <summary>Time spent, of which <see cref="Bytes"/> give a speed.</summary>
    public TimeSpan Time { get; set; }

    public FuzzFinding? Finding { get; set; }

    public bool IsDone => Finding is not null || Bytes >= budget;

    /// <summary>Makes and runs the next input; a failure is made small and kept.</summary>
    public void Step()
    {
        long number = _inputs;
        ReadOnlySpan<byte> input = _mutator.Make(number);
        FuzzFailure? failure = Runner.Run(input);
        Volatile.Write(ref _inputs, number + 1);
        Volatile.Write(ref _bytes, _bytes + input.Length);
        if (failure is not null)
            Finding = Explain(target, Runner, number, input.ToArray(), failure);
    }

    public static FuzzFinding Explain(FuzzTarget target, InputRunner runner, long number, byte[] input, FuzzFailure failure)
    {
        byte[] smallest = Minimizer.Minimize(input, shorter => runner.Run(shorter, isThorough: true)?.Kind == failure.Kind);
        FuzzFailure shown = runner.Run(smallest, isThorough: true) ?? failure;
        return new FuzzFinding(target.Name, shown, number, input, smallest);
    }
}
