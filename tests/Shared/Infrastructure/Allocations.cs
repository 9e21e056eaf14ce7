using System.Diagnostics;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// Measures the allocations of code in rounds, and takes the minimum. Code may allocate in every call until the runtime has optimized it, which another
/// thread does. The runtime allocates when it recompiles a method, and other threads may allocate at any time. On a busy machine that may disturb many
/// rounds. Code that really allocates does so in every round.
/// </summary>
internal static class Allocations
{
    // The pauses between them take a minute.
    private const int MaxRounds = 600;

    // Methods are optimized after 30 calls, or 256 if dotnet test runs them.
    private const int WarmUp = 300;

    /// <summary>
    /// Asserts that an action allocates nothing on this thread after a warm-up. It is called 300 times, and then <paramref name="calls"/> times in each
    /// of up to 600 rounds.
    /// </summary>
    public static void AssertNone(Action action, int calls = 100)
    {
        for (int i = 0; i < WarmUp; i++)
            action();

        Assert.Equal(0, Least(() => OnThisThread(action, calls)));
    }

    /// <summary>Returns the exact allocations of an action on this thread.</summary>
    public static long OnThisThread(Action action, int calls = 1)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < calls; i++)
            action();

        return GC.GetAllocatedBytesForCurrentThread() - before;
    }

    /// <summary>Returns the minimum of the rounds. Ends with the first round that is 0.</summary>
    public static long Least(Func<long> measure)
    {
        long least = measure();
        for (int round = 1; round < MaxRounds && least > 0; round++)
        {
            // Gives the thread that optimizes code its turn. Nothing tells when it is done.
            Thread.Sleep(Math.Min(round, 100));
            least = Math.Min(least, measure());
        }

        return least;
    }

    /// <summary>
    /// Returns the minimum of what all threads allocate while an action runs, which should take some milliseconds. Ends with the first round at or
    /// below the limit. For tests that run alone.
    /// </summary>
    public static long LeastOfProcess(Action action, long enough = 0)
    {
        // No pause: what arrives in it would not be measured, and such an action waits for other threads itself.
        long least = long.MaxValue;
        long start = Stopwatch.GetTimestamp();
        do
        {
            long before = GC.GetTotalAllocatedBytes(precise: true);
            action();
            least = Math.Min(least, GC.GetTotalAllocatedBytes(precise: true) - before);
        }
        while (least > enough && Stopwatch.GetElapsedTime(start) < Limits.Unexpected);
        return least;
    }
}
