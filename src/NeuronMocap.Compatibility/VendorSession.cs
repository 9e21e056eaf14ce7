using System.Diagnostics;
using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;
using ManagedReader = NeuronDataReaderManaged.NeuronDataReader;
using WrappedReader = NeuronDataReaderWraper.NeuronDataReader;

namespace NeuronMocap.Compatibility;

/// <summary>Closes everything that scripts have opened and registered, in both namespaces.</summary>
/// <remarks>
/// It is for hosts that end a program but not the process. Unity's editor does so when it leaves play mode or recompiles scripts. Connections that a
/// script forgot to close would otherwise stay open.
/// </remarks>
public static class VendorSession
{
    /// <summary>
    /// Unregisters all callbacks, and closes every connection, UDP service and command connection at the same time.
    /// </summary>
    /// <remarks>
    /// Thread-safe. You can call it repeatedly. Closed handles stay invalid. Later connections work as at the start of the process.
    /// </remarks>
    /// <param name="timeout">
    /// Maximum time to wait for running callbacks. <see cref="Timeout.InfiniteTimeSpan"/> and longer times than 24 days count as 24 days.
    /// </param>
    /// <returns>
    /// False if a callback was still running after that time. Its connection is closed nevertheless, and no other callback follows.
    /// </returns>
    public static bool End(TimeSpan timeout)
    {
        // The longest time that a thread can be joined.
        var longest = TimeSpan.FromMilliseconds(int.MaxValue);
        if (timeout == Timeout.InfiniteTimeSpan || timeout > longest)
            timeout = longest;

        WrappedReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
        WrappedReader.BRRegisterCalculationDataCallback(IntPtr.Zero, null);
        WrappedReader.BRRegisterSocketStatusCallback(IntPtr.Zero, null);
        WrappedReader.BRRegisterCommandDataCallback(IntPtr.Zero, null);
        ManagedReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
        ManagedReader.BRRegisterCalculationDataCallback(IntPtr.Zero, null);
        ManagedReader.BRRegisterSocketStatusCallback(IntPtr.Zero, null);
        ManagedReader.BRRegisterCommandDataCallback(IntPtr.Zero, null);

        // Each socket is closed on its own thread, which a busy pool cannot delay. Closing waits for the callback of the connection.
        var watch = Stopwatch.StartNew();
        Thread[] closing = [.. SocketTable.GetAll().Select(socket => new Thread(() => Close(socket, timeout)) { IsBackground = true, Name = "NeuronMocap close" })];
        Array.ForEach(closing, static thread => thread.Start());
        bool areClosed = Array.TrueForAll(closing, thread => thread.Join(Rest()));
        return CallbackGate.WaitUntilClosedAreIdle(Rest()) && areClosed;

        TimeSpan Rest() => timeout > watch.Elapsed ? timeout - watch.Elapsed : TimeSpan.Zero;
    }

    private static void Close(VendorSocket socket, TimeSpan timeout) => FunctionGuard.Call(
        (socket, timeout), static what => what.socket.Close(what.timeout), failure: false, nameof(End));
}
