using System.Diagnostics;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// Counts what a process must not lose. For tests that run alone: everything in the process is counted. On Linux sockets and the library's
/// threads are counted exactly, elsewhere all handles, with some room for the runtime's own.
/// </summary>
internal static class ProcessResources
{
    private const string Descriptors = "/proc/self/fd";
    private const string Tasks = "/proc/self/task";
    private const int RuntimesOwn = 50;

    public static int Sockets => OperatingSystem.IsLinux() ? CountSockets() : CountHandles();

    /// <summary>Threads whose name begins as those of the library do; pool threads come and go and are not counted.</summary>
    public static int LibraryThreads => OperatingSystem.IsLinux() ? CountThreads("NeuronMocap") : 0;

    /// <summary>Threads that wait for a TCP connection or its bytes; of a thread's name Linux keeps 15 characters.</summary>
    public static int TcpThreads => OperatingSystem.IsLinux() ? CountThreads("NeuronMocap TCP") : 0;

    /// <summary>Bytes of the objects that are still in use. GC.GetTotalMemory is off by what was freed in old generations, at times below zero.</summary>
    public static long LiveHeap()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();
        GCMemoryInfo info = GC.GetGCMemoryInfo(GCKind.FullBlocking);
        return info.HeapSizeBytes - info.FragmentedBytes;
    }

    /// <summary>Waits until there are no more sockets and threads than before: some go a moment after those who used them.</summary>
    public static Task AssertNoMoreAsync(int sockets, int threads)
    {
        int room = OperatingSystem.IsLinux() ? 0 : RuntimesOwn;
        return Limits.UntilAsync(() => Sockets <= sockets + room && LibraryThreads <= threads);
    }

    private static int CountSockets()
    {
        int count = 0;
        foreach (string path in Directory.EnumerateFiles(Descriptors))
        {
            try
            {
                if (File.ResolveLinkTarget(path, returnFinalTarget: false)?.Name.StartsWith("socket:", StringComparison.Ordinal) == true)
                    count++;
            }
            catch (IOException)
            {
                // It was closed meanwhile, like the one that this enumeration uses.
            }
        }

        return count;
    }

    private static int CountThreads(string name)
    {
        int count = 0;
        foreach (string path in Directory.EnumerateDirectories(Tasks))
        {
            try
            {
                if (File.ReadAllText(Path.Combine(path, "comm")).StartsWith(name, StringComparison.Ordinal))
                    count++;
            }
            catch (IOException)
            {
                // It has ended meanwhile.
            }
        }

        return count;
    }

    private static int CountHandles()
    {
        using var process = Process.GetCurrentProcess();
        return process.HandleCount;
    }
}
