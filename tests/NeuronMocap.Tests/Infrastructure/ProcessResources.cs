using System.Diagnostics;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// Counts resources that a process must not leak. For tests that run alone, because it counts everything in the process. On Linux, it counts sockets
/// and the library's threads exactly. Elsewhere it counts all handles, with an allowance for the runtime's own.
/// </summary>
internal static class ProcessResources
{
    private const string Descriptors = "/proc/self/fd";
    private const string Tasks = "/proc/self/task";
    private const int RuntimesOwn = 50;

    public static int Sockets => OperatingSystem.IsLinux() ? CountSockets() : CountHandles();

    /// <summary>Threads with the name prefix of the library. Pool threads come and go and are not counted.</summary>
    public static int LibraryThreads => OperatingSystem.IsLinux() ? CountThreads("NeuronMocap") : 0;

    /// <summary>Threads that wait for a TCP connection or its bytes. Linux keeps 15 characters of a thread's name.</summary>
    public static int TcpThreads => OperatingSystem.IsLinux() ? CountThreads("NeuronMocap TCP") : 0;

    /// <summary>Bytes of live objects. GC.GetTotalMemory includes memory freed in old generations, and is sometimes below zero.</summary>
    public static long LiveHeap()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();
        GCMemoryInfo info = GC.GetGCMemoryInfo(GCKind.FullBlocking);
        return info.HeapSizeBytes - info.FragmentedBytes;
    }

    /// <summary>Waits until there are no more sockets and threads than before. Some end a moment after their users.</summary>
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
                // It was closed in the meantime, like the handle that this enumeration uses.
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
                // It has ended in the meantime.
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
