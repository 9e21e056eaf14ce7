using System.Diagnostics;
using System.Runtime.InteropServices;

namespace NeuronMocap.Benchmarks.Harness;

// The processor time of the calling thread. On a busy machine, it leaves out the time in which other threads run.
internal static class ThreadClock
{
    private const int ThreadCpuTime = 3;

    // Outside Linux, the time on the wall.
    public static double Nanoseconds
    {
        get
        {
            if (OperatingSystem.IsLinux() && GetTime(ThreadCpuTime, out Time time) == 0)
                return (time.Seconds * 1e9) + time.Nanoseconds;

            return Stopwatch.GetTimestamp() * 1e9 / Stopwatch.Frequency;
        }
    }

    [DllImport("libc", EntryPoint = "clock_gettime")]
    private static extern int GetTime(int clock, out Time time);

    [StructLayout(LayoutKind.Sequential)]
    private struct Time
    {
        public nint Seconds;
        public nint Nanoseconds;
    }
}
