using System.Diagnostics.CodeAnalysis;
using System.Text;
using NeuronMocap.Commands;
using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Compatibility;

// What the functions of one of the two namespaces do.
internal sealed class VendorFunctions(IVendorCallbacks callbacks)
{
    public IntPtr Connect(string host, int port) => SocketTable.Open(new TcpDataSocket(callbacks, host, port));

    public IntPtr StartUdpService(int port) => SocketTable.Open(new UdpDataSocket(callbacks, port));

    public IntPtr ConnectCommands(string host, int port) => SocketTable.Open(new CommandSocket(callbacks, host, port));

    public static SocketState GetStatus(IntPtr socket) => SocketTable.Find(socket)?.State ?? SocketState.OffWork;

    public static void Close(IntPtr socket) => SocketTable.Find(socket)?.Dispose();

    // The numbers of the vendor's commands are those of the wire.
    public static bool Fetch(IntPtr socket, int command, int avatar) => CommandsOf(socket)?.TryFetch((DataCommandId)command, avatar) ?? false;

    public static bool Register(IntPtr socket, int command) => CommandsOf(socket)?.TryRegister((DataCommandId)command) ?? false;

    public static bool Unregister(IntPtr socket, int command) => CommandsOf(socket)?.TryUnregister((DataCommandId)command) ?? false;

    public static bool ZeroOut(IntPtr socket, int avatar) => TryTell(socket, client => client.ZeroOutAsync(avatar));

    public static bool ZeroOutAll(IntPtr socket) => TryTell(socket, static client => client.ZeroOutAllAsync());

    public static bool TryGetRotationOrder(IntPtr socket, out RotationOrder order) =>
        TryAsk(socket, static client => client.GetRotationOrderAsync(), out order);

    public static bool TryGetBoneDimensions(IntPtr socket, int avatar, out BoneDimensions dimensions) =>
        TryAsk(socket, client => client.GetBoneDimensionsAsync(avatar), out dimensions);

    public static bool TryGetBvhHeader(IntPtr socket, int avatar, [NotNullWhen(true)] out string? text) =>
        TryAsk(socket, client => client.GetBvhHeaderTextAsync(avatar), out text);

    // As C text, with the zero byte at its end.
    public static bool TryGetBvhHeader(IntPtr socket, int avatar, [NotNullWhen(true)] out byte[]? bytes)
    {
        bytes = TryGetBvhHeader(socket, avatar, out string? text) ? Encoding.UTF8.GetBytes(text + '\0') : null;
        return bytes is not null;
    }

    private static bool TryTell(IntPtr socket, Func<NeuronCommandClient, Task> tell) =>
        SocketTable.Find(socket) is CommandSocket command && command.TryCall(tell);

    private static bool TryAsk<T>(IntPtr socket, Func<NeuronCommandClient, Task<T>> ask, out T? answer)
    {
        Task<T>? answered = null;
        bool told = SocketTable.Find(socket) is CommandSocket command && command.TryCall(client => answered = ask(client));
        answer = told ? answered!.Result : default;
        return told;
    }

    private static DataCommands? CommandsOf(IntPtr socket) => (SocketTable.Find(socket) as DataSocket)?.Commands;
}
