using System.Diagnostics;
using System.Runtime.InteropServices;

namespace NeuronMocap.Recording;

// Sleeps for less than a millisecond, which .NET cannot. Only on 64-bit Linux, where a thread wakes about 0.1 ms late.
internal static class PreciseSleep
{
    private static volatile bool _isMissing = !OperatingSystem.IsLinux() || IntPtr.Size != sizeof(long);

    public static bool IsAvailable => !_isMissing;

    // Ticks of Stopwatch, less than a second. Returns earlier after a signal.
    public static void Sleep(long ticks)
    {
        var time = new Duration { Nanoseconds = ticks * 1_000_000_000 / Stopwatch.Frequency };
        try
        {
            _ = nanosleep(ref time, IntPtr.Zero);
        }
        catch (Exception exception) when (exception is DllNotFoundException or EntryPointNotFoundException)
        {
            _isMissing = true;
        }
    }

    [DllImport("libc")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.System32)]
    private static extern int nanosleep(ref Duration time, IntPtr rest);

    // The struct timespec of 64-bit systems.
    [StructLayout(LayoutKind.Sequential)]
    private struct Duration
    {
        public long Seconds;
        public long Nanoseconds;
    }
}
