using System.Diagnostics.CodeAnalysis;
using System.Text;
using NeuronMocap.Commands;
using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Compatibility;

// Implements the functions of one of the two namespaces.
internal sealed class VendorFunctions(IVendorCallbacks callbacks)
{
    public IntPtr Connect(string host, int port) => FunctionGuard.Call(
        (callbacks, host, port), static to => SocketTable.Open(new TcpDataSocket(to.callbacks, to.host, to.port)), IntPtr.Zero, "BRConnectTo");

    public IntPtr StartUdpService(int port) => FunctionGuard.Call(
        (callbacks, port), static at => SocketTable.Open(new UdpDataSocket(at.callbacks, at.port)), IntPtr.Zero, "BRStartUDPServiceAt");

    public IntPtr ConnectCommands(string host, int port) => FunctionGuard.Call(
        (callbacks, host, port), static to => SocketTable.Open(new CommandSocket(to.callbacks, to.host, to.port)), IntPtr.Zero, "BRConnectCmd");

    public static SocketState GetStatus(IntPtr socket) => FunctionGuard.Call(
        socket, static socket => SocketTable.Find(socket)?.State ?? SocketState.OffWork, SocketState.OffWork, "BRGetSocketStatus");

    public static void Close(IntPtr socket) => FunctionGuard.Call(
        socket,
        static socket =>
        {
            SocketTable.Find(socket)?.Dispose();
            return true;
        },
        failure: false,
        "BRCloseSocket");

    // The numbers of the vendor's commands are those of the protocol.
    public static bool Fetch(IntPtr socket, int command, int avatar) => FunctionGuard.Call(
        (socket, command, avatar),
        static what => CommandsOf(what.socket)?.TryRequest((DataCommandId)what.command, what.avatar) ?? false,
        failure: false,
        "BRCommandFetchDataFromServer");

    public static bool Register(IntPtr socket, int command) => FunctionGuard.Call(
        (socket, command),
        static what => CommandsOf(what.socket)?.TryRegister((DataCommandId)what.command) ?? false,
        failure: false,
        "BRRegisterAutoSyncParmeter");

    public static bool Unregister(IntPtr socket, int command) => FunctionGuard.Call(
        (socket, command),
        static what => CommandsOf(what.socket)?.TryUnregister((DataCommandId)what.command) ?? false,
        failure: false,
        "BRUnregisterAutoSyncParmeter");

    public static bool ZeroOut(IntPtr socket, int avatar) => TrySend(socket, (client, cancel) => client.ZeroOutAsync(avatar, cancel), nameof(ZeroOut));

    public static bool ZeroOutAll(IntPtr socket) => TrySend(socket, static (client, cancel) => client.ZeroOutAllAsync(cancel), nameof(ZeroOutAll));

    public static bool TryGetRotationOrder(IntPtr socket, out RotationOrder order) =>
        TryAsk(socket, static (client, cancel) => client.GetRotationOrderAsync(cancel), out order, "GetBvhRotation");

    public static bool TryGetBoneDimensions(IntPtr socket, int avatar, out BoneDimensions dimensions) =>
        TryAsk(socket, (client, cancel) => client.GetBoneDimensionsAsync(avatar, cancel), out dimensions, "GetBoneSize");

    public static bool TryGetBvhHeader(IntPtr socket, int avatar, [NotNullWhen(true)] out string? text) =>
        TryAsk(socket, (client, cancel) => client.GetBvhHeaderTextAsync(avatar, cancel), out text, "GetBvhHeader");

    // Returns C text with a zero byte at its end.
    public static bool TryGetBvhHeader(IntPtr socket, int avatar, [NotNullWhen(true)] out byte[]? bytes)
    {
        bytes = TryGetBvhHeader(socket, avatar, out string? text)
            ? FunctionGuard.Call(text, static text => Encoding.UTF8.GetBytes(text + '\0'), failure: null, "GetBvhHeader")
            : null;
        return bytes is not null;
    }

    private static bool TrySend(IntPtr socket, Func<NeuronCommandClient, CancellationToken, Task> send, string name) => FunctionGuard.Call(
        (socket, send),
        static what => SocketTable.Find(what.socket) is CommandSocket command && command.TryCall(what.send),
        failure: false,
        name);

    private static bool TryAsk<T>(IntPtr socket, Func<NeuronCommandClient, CancellationToken, Task<T>> ask, out T? answer, string name)
    {
        Task<T>? answered = null;
        bool isSent = TrySend(socket, (client, cancel) => answered = ask(client, cancel), name);
        answer = isSent ? answered!.Result : default;
        return isSent;
    }

    private static DataCommands? CommandsOf(IntPtr socket) => (SocketTable.Find(socket) as DataSocket)?.Commands;
}
