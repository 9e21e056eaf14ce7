using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Native.Host;

// The functions that entry.c calls. entry.c stands in front of the exports on Linux.
internal static unsafe partial class Entry
{
    private const int NoThreads = 11;

    // A callback may wait for the thread that ends the process.
    private static readonly TimeSpan ExitTimeout = TimeSpan.FromSeconds(1);

    public static void SetHandlers()
    {
        if (OperatingSystem.IsLinux())
            SetHandlers(&OnExit, &OnRefusal);
    }

    // Runs on the thread that ends the process, perhaps in a callback.
    [UnmanagedCallersOnly]
    private static void OnExit() => ExportGuard.Run(ExitTimeout, static timeout => CallbackGate.EndProcess(timeout));

    [UnmanagedCallersOnly]
    private static void OnRefusal() => ExportGuard.Run(NoThreads, static error => LastError.Set("Failed to start the threads of a connection.", error));

    [LibraryImport("entry", EntryPoint = "NeuronMocapSetHandlers")]
    private static partial void SetHandlers(delegate* unmanaged<void> onExit, delegate* unmanaged<void> onRefusal);
}
