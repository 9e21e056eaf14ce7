namespace NeuronMocap.Tests.Infrastructure;

internal static class Allocations
{
    /// <summary>Asserts that an action, once warm, allocates nothing on this thread; other threads do not disturb the measurement.</summary>
    public static void AssertNone(Action action)
    {
        for (int i = 0; i < 50; i++)
            action();

        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++)
            action();

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }
}
