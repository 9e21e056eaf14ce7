namespace NeuronMocap.Tests.Infrastructure;

internal static class Allocations
{
    private const int Rounds = 3;

    /// <summary>
    /// Asserts that an action, once warm, allocates nothing on this thread; other threads do not disturb the measurement. The runtime itself allocates once
    /// where it compiles a method anew, at a moment of its own: an action that allocates does so in every round.
    /// </summary>
    public static void AssertNone(Action action)
    {
        for (int i = 0; i < 50; i++)
            action();

        long least = long.MaxValue;
        for (int round = 0; round < Rounds && least > 0; round++)
            least = Math.Min(least, Measure(action));

        Assert.Equal(0, least);
    }

    private static long Measure(Action action)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++)
            action();

        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
