namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>What rendered frames allocate on the main thread.</summary>
internal static class FrameAllocations
{
    /// <summary>Asserts that frames of a scene, once warm, allocate nothing; other threads do not disturb the measurement.</summary>
    /// <param name="loop">Whose scene.</param>
    /// <param name="between">Called before each frame, outside of what is measured: waits for data, for example.</param>
    public static void AssertNone(PlayerLoop loop, Action? between = null) => Assert.Equal(0, Measure(loop, 100, between));

    public static long Measure(PlayerLoop loop, int frames, Action? between = null)
    {
        for (int i = 0; i < 50; i++)
            Run(loop, between);

        long bytes = 0;
        for (int i = 0; i < frames; i++)
            bytes += Run(loop, between);

        return bytes;
    }

    private static long Run(PlayerLoop loop, Action? between)
    {
        between?.Invoke();
        long before = GC.GetAllocatedBytesForCurrentThread();
        loop.Frame();
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
