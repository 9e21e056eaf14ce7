using System.Diagnostics;

namespace NeuronMocap.Benchmarks.Harness;

// Measures the cost of one frame on one thread with a hot cache.
internal static class HotLoop
{
    public const int Rounds = 200_000;

    public static Measurements Measure(Action<int> step)
    {
        for (int i = 0; i < 1000; i++)
            step(i);

        long allocated = RuntimeFigures.AllocatedBytesOfThread;
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < Rounds; i++)
            step(i);

        double nanoseconds = Stopwatch.GetElapsedTime(start).TotalMilliseconds * 1e6 / Rounds;
        allocated = RuntimeFigures.AllocatedBytesOfThread - allocated;
        return new Measurements { ["ns/frame"] = nanoseconds, ["B/frame"] = allocated / (double)Rounds };
    }
}
