using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;

namespace NeuronMocap.Native.Host;

// What entry.c calls, which stands in front of the exports on Linux.
internal static unsafe partial class Entry
{
    private const int NoThreads = 11;

    public static void SetHandlers()
    {
        if (OperatingSystem.IsLinux())
            SetHandlers(&OnExit, &OnRefusal);
    }

    // On the thread that ends the process, perhaps in a callback.
    [UnmanagedCallersOnly]
    private static void OnExit() => CallbackGate.Close();

    [UnmanagedCallersOnly]
    private static void OnRefusal() => LastError.Set("Failed to start the threads of a connection.", NoThreads);

    [LibraryImport("entry", EntryPoint = "NeuronMocapSetHandlers")]
    private static partial void SetHandlers(delegate* unmanaged<void> onExit, delegate* unmanaged<void> onRefusal);
}
