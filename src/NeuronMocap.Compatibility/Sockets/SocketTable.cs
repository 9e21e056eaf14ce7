using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// All handles of the process.
internal static class SocketTable
{
    private static readonly object Lock = new();
    private static readonly Dictionary<IntPtr, VendorSocket> Sockets = [];
    private static int _lastHandle;

    // Returns the handle of the socket, or of an existing socket to the same target, or zero.
    public static IntPtr Open(VendorSocket socket)
    {
        bool isOpen = false;
        try
        {
            if (FindSame(socket) is { } other)
                return other.WaitUntilOpen() ? other.Handle : IntPtr.Zero;

            isOpen = socket.Open();
            return isOpen ? socket.Handle : IntPtr.Zero;
        }
        finally
        {
            if (!isOpen)
            {
                Remove(socket);
                socket.Abandon();
            }
        }
    }

    public static VendorSocket? Find(IntPtr handle)
    {
        lock (Lock)
            return Sockets.TryGetValue(handle, out VendorSocket? socket) ? socket : null;
    }

    public static VendorSocket[] GetAll()
    {
        lock (Lock)
            return [.. Sockets.Values];
    }

    public static void Remove(VendorSocket socket)
    {
        lock (Lock)
            Sockets.Remove(socket.Handle);
    }

    // Adds the socket if the table has no socket to the same target. A dead socket is replaced. Its handle then becomes invalid and is never used
    // again.
    private static VendorSocket? FindSame(VendorSocket socket)
    {
        VendorSocket? other;
        lock (Lock)
        {
            other = Sockets.Values.FirstOrDefault(socket.IsTo);
            if (other is { State: not SocketState.OffWork })
                return other;

            if (other is not null)
                Sockets.Remove(other.Handle);
            _lastHandle++;
            socket.Handle = (IntPtr)_lastHandle;
            Sockets.Add(socket.Handle, socket);
        }

        other?.Abandon();
        return null;
    }
}
