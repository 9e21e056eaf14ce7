using System.Diagnostics;
using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Running;

/// <summary>Feeds inputs to targets, a slice to each in turn, up to a number of bytes. The inputs of the folder corpus come first.</summary>
internal sealed class FuzzRun
{
    private const long Slice = 256 * 1024;

    private static readonly TimeSpan Look = TimeSpan.FromMilliseconds(50);

    private readonly CancellationToken _cancellationToken;
    private volatile TargetProgress? _running;

    /// <summary>Creates a run.</summary>
    /// <param name="targets">The targets.</param>
    /// <param name="bytes">Total bytes of all inputs. Empty inputs count for none.</param>
    /// <param name="seed">The same seed and the same recordings give the same inputs.</param>
    /// <param name="data">A folder of recordings, or null.</param>
    /// <param name="cancellationToken">Ends the run after the current input.</param>
    public FuzzRun(IReadOnlyList<FuzzTarget> targets, long bytes, ulong seed, string? data, CancellationToken cancellationToken = default)
    {
        _cancellationToken = cancellationToken;
        Corpora = targets.Select(target => target.Corpus).Distinct().ToDictionary(kind => kind, kind => Corpus.Load(kind, data));
        double shares = targets.Sum(target => target.Share);
        Progress = [.. targets.Select(target => new TargetProgress(target, Corpora[target.Corpus], seed, (long)(bytes * target.Share / shares), KeptInputs.All))];
    }

    public IReadOnlyDictionary<CorpusKind, Corpus> Corpora { get; }

    public IReadOnlyList<TargetProgress> Progress { get; }

    /// <summary>Whether an input did not end, and the thread that reads it still runs.</summary>
    public bool IsCutShort { get; private set; }

    /// <summary>Runs to the end, to the cancellation, or to the first input that does not return.</summary>
    /// <param name="report">Called occasionally, on this thread.</param>
    public void Run(Action report)
    {
        // A hanging thread cannot be ended. As a background thread it does not keep the program alive.
        var worker = new Thread(RunTargets, maxStackSize: 1 << 20) { IsBackground = true, Name = "Fuzzing" };
        worker.Start();
        while (!worker.Join(Look))
        {
            report();
            if (_running is { } running && running.Runner.FindOverrun() is var (failure, input))
            {
                IsCutShort = true;
                running.AddOverrun(failure, input);
                running.Target.Stop?.Invoke();
                return;
            }
        }
    }

    private void RunTargets()
    {
        while (Progress.Any(target => !target.IsDone))
        {
            foreach (TargetProgress target in Progress)
            {
                RunSlice(target);
                if (_cancellationToken.IsCancellationRequested)
                    return;
            }
        }
    }

    private void RunSlice(TargetProgress target)
    {
        _running = target;
        long start = Stopwatch.GetTimestamp();
        long end = target.Bytes + Slice;
        while (!target.IsDone && target.Bytes < end && !_cancellationToken.IsCancellationRequested)
            target.Step();

        target.Time += Stopwatch.GetElapsedTime(start);
    }
}
