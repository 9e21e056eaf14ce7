using System.Diagnostics;
using System.Runtime.InteropServices;

namespace NeuronMocap.Benchmarks.Harness;

// Processor time in nanoseconds. On a busy machine, it leaves out the time in which other threads or programs run.
internal static class CpuClock
{
    private const int ProcessCpuTime = 2;
    private const int ThreadCpuTime = 3;

    // Of the calling thread. Outside Linux, the time on the wall.
    public static double OfThread => Read(ThreadCpuTime) ?? Stopwatch.GetTimestamp() * 1e9 / Stopwatch.Frequency;

    // Of all threads of this process. Outside Linux, in coarser steps.
    public static double OfProcess => Read(ProcessCpuTime) ?? RuntimeFigures.CpuTime.TotalNanoseconds;

    private static double? Read(int clock) =>
        OperatingSystem.IsLinux() && GetTime(clock, out Time time) == 0 ? (time.Seconds * 1e9) + time.Nanoseconds : null;

    [DllImport("libc", EntryPoint = "clock_gettime")]
    private static extern int GetTime(int clock, out Time time);

    [StructLayout(LayoutKind.Sequential)]
    private struct Time
    {
        public nint Seconds;
        public nint Nanoseconds;
    }
}
