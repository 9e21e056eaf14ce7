using System.Diagnostics;
using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;
using ManagedReader = NeuronDataReaderManaged.NeuronDataReader;
using WrappedReader = NeuronDataReaderWraper.NeuronDataReader;

namespace NeuronMocap.Compatibility;

/// <summary>
/// All that scripts have opened and registered, in both namespaces. For hosts that end a program but not the process, as Unity's editor does when
/// play mode is left or scripts are compiled again: what a script forgot to close would go on there.
/// </summary>
public static class VendorSession
{
    /// <summary>
    /// Unregisters all callbacks, and closes every connection, UDP service and command connection, all at once. May be called from any thread and
    /// repeatedly. Handles that were closed stay dead; what is opened afterwards works as at the start of the process.
    /// </summary>
    /// <param name="timeout">How long to wait at most for callbacks that are running.</param>
    /// <returns>False when a callback was still running after that time. Its connection is closed, too, and no other call follows.</returns>
    public static bool End(TimeSpan timeout)
    {
        WrappedReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
        WrappedReader.BRRegisterCalculationDataCallback(IntPtr.Zero, null);
        WrappedReader.BRRegisterSocketStatusCallback(IntPtr.Zero, null);
        WrappedReader.BRRegisterCommandDataCallback(IntPtr.Zero, null);
        ManagedReader.BRRegisterFrameDataCallback(IntPtr.Zero, null);
        ManagedReader.BRRegisterCalculationDataCallback(IntPtr.Zero, null);
        ManagedReader.BRRegisterSocketStatusCallback(IntPtr.Zero, null);
        ManagedReader.BRRegisterCommandDataCallback(IntPtr.Zero, null);

        // Each on a thread of its own, which no busy pool can delay: closing waits for the connection's callback.
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
