namespace NeuronMocap.Benchmarks.Harness;

// What the runtime counts about this process.
internal static class RuntimeFigures
{
    public static bool IsMono => false;

    public static TimeSpan CpuTime => Environment.CpuUsage.TotalTime;

    // Of all threads; null where the runtime does not count them.
    public static long? AllocatedBytes => GC.GetTotalAllocatedBytes(precise: true);

    public static long AllocatedBytesOfThread => GC.GetAllocatedBytesForCurrentThread();
}
