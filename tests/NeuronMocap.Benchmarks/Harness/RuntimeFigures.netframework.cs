using System.Diagnostics;
using System.Reflection;

namespace NeuronMocap.Benchmarks.Harness;

// The same on Mono, which counts allocations of one thread only. .NET Framework's reference assemblies do not know the method.
internal static class RuntimeFigures
{
    private static readonly Func<long> Allocated = (Func<long>)Delegate.CreateDelegate(
        typeof(Func<long>), typeof(GC).GetMethod("GetAllocatedBytesForCurrentThread", BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic)!);

    public static bool IsMono => true;

    public static TimeSpan CpuTime
    {
        get
        {
            using Process process = Process.GetCurrentProcess();
            return process.TotalProcessorTime;
        }
    }

    public static long? AllocatedBytes => null;

    public static long AllocatedBytesOfThread => Allocated();
}
