using NeuronMocap.Commands;
using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Compatibility;

// What the functions of one of the two namespaces do.
internal sealed class VendorFunctions(IVendorCallbacks callbacks)
{
    public IntPtr Connect(string host, int port) => SocketTable.Open(new TcpDataSocket(callbacks, host, port));

    public IntPtr StartUdpService(int port) => SocketTable.Open(new UdpDataSocket(callbacks, port));

    public static SocketState GetStatus(IntPtr socket) => SocketTable.Find(socket)?.State ?? SocketState.OffWork;

    public static void Close(IntPtr socket) => SocketTable.Find(socket)?.Dispose();

    // The numbers of the vendor's commands are those of the wire.
    public static bool Fetch(IntPtr socket, int command, int avatar) => CommandsOf(socket)?.TryFetch((DataCommandId)command, avatar) ?? false;

    public static bool Register(IntPtr socket, int command) => CommandsOf(socket)?.TryRegister((DataCommandId)command) ?? false;

    public static bool Unregister(IntPtr socket, int command) => CommandsOf(socket)?.TryUnregister((DataCommandId)command) ?? false;

    private static DataCommands? CommandsOf(IntPtr socket) => (SocketTable.Find(socket) as DataSocket)?.Commands;
}
