using System.Diagnostics;
using System.Globalization;
using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Running;

/// <summary>The program's output: a line every few seconds on standard error, and the summary on standard output.</summary>
internal sealed class FuzzReport(FuzzRun run, long bytes)
{
    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(3);

    private readonly long _start = Stopwatch.GetTimestamp();
    private TimeSpan _next = Interval;

    private TimeSpan Elapsed => Stopwatch.GetElapsedTime(_start);

    public static string DescribeCorpora(FuzzRun run, ulong seed, string? data)
    {
        IEnumerable<string> counts = run.Corpora.Select(
            corpus => string.Create(
                CultureInfo.InvariantCulture,
                $"{NameOf(corpus.Key)}: {corpus.Value.OwnCount} own fixtures, {corpus.Value.Fixtures.Count - corpus.Value.OwnCount} recorded"));
        string where = data is null ? "no folder of recordings, skipped" : $"recordings from {data}";
        return string.Create(CultureInfo.InvariantCulture, $"seed {seed}; {KeptInputs.All.Count} kept inputs; {string.Join("; ", counts)} ({where})");
    }

    public void Tick()
    {
        if (Elapsed < _next)
            return;

        _next = Elapsed + Interval;
        long done = run.Progress.Sum(target => target.Bytes);
        double speed = done / Elapsed.TotalSeconds;
        TimeSpan left = TimeSpan.FromSeconds(Math.Round(Math.Max(0, bytes - done) / Math.Max(1, speed)));
        Console.Error.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{Megabytes(done)} of {Megabytes(bytes)} MB, {speed / 1e6:0.0} MB/s, {left:h\\:mm\\:ss} left"));
    }

    public void Summarize()
    {
        Console.WriteLine("target          inputs        MB    MB/s     found  slowest ms  failures");
        foreach (TargetProgress target in run.Progress)
        {
            double speed = target.Bytes / 1e6 / Math.Max(1e-6, target.Time.TotalSeconds);
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{target.Target.Name,-12}{target.Inputs,10}{Megabytes(target.Bytes),10}{speed,8:0.0}{target.Runner.Found,10}"
                + $"{target.Runner.Slowest.TotalMilliseconds,12:0}{target.Failures,10}"));
        }

        long done = run.Progress.Sum(target => target.Bytes);
        int failures = run.Progress.Count(target => target.Failures > 0);
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{done} bytes in {Elapsed.TotalSeconds:0.0} s, {done / 1e6 / Elapsed.TotalSeconds:0.0} MB/s; "
            + $"{failures} of {run.Progress.Count} targets failed"));
    }

    private static string NameOf(CorpusKind kind) => kind switch
    {
        CorpusKind.Bvh => "BVH",
        _ => kind.ToString().ToLowerInvariant(),
    };

    private static string Megabytes(long count) => (count / 1e6).ToString("0.0", CultureInfo.InvariantCulture);
}
