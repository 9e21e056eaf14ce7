using System.Diagnostics;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// Measures what code allocates, in rounds, and takes the least of them. The runtime allocates where it compiles a method anew, and other threads of the
/// process as they like; on a busy machine that goes on for many rounds. Code that allocates does so in each of them.
/// </summary>
internal static class Allocations
{
    private const int WarmUp = 50;
    private const int Rounds = 20;

    /// <summary>Asserts that an action, once warm, allocates nothing on this thread. It is called up to 50 + 20 * <paramref name="calls"/> times.</summary>
    public static void AssertNone(Action action, int calls = 100)
    {
        for (int i = 0; i < WarmUp; i++)
            action();

        Assert.Equal(0, Least(() => OnThisThread(action, calls)));
    }

    /// <summary>What an action allocates on this thread, to the byte.</summary>
    public static long OnThisThread(Action action, int calls = 1)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < calls; i++)
            action();

        return GC.GetAllocatedBytesForCurrentThread() - before;
    }

    /// <summary>The least of some rounds; ends with the first that is 0.</summary>
    public static long Least(Func<long> measure)
    {
        long least = long.MaxValue;
        for (int round = 0; round < Rounds && least > 0; round++)
            least = Math.Min(least, measure());

        return least;
    }

    /// <summary>
    /// The least that all threads allocate while an action runs, which is to take some milliseconds: ends with the first time that is enough. For tests that
    /// run alone.
    /// </summary>
    public static long LeastOfProcess(Action action, long enough = 0)
    {
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
