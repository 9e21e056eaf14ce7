using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class UdpReceiver
{
    private const int MaxDatagram = 65_536;

    // Whether a port can have a thread of its own.
    public const bool HasThreads = true;

    // Throws when the gate or the socket is closed, or when the socket fails.
    public static Task ReceiveAsync(Socket socket, UdpSenders senders, ReceiveGate gate, ReceiveThread thread) => gate.UntilClosedAsync(
        thread == ReceiveThread.Dedicated
            ? DedicatedThread.RunAsync("NeuronMocap UDP receive", () => Loop(socket, senders, gate), TaskCreationOptions.None)
            : LoopAsync(socket, senders, gate));

    private static void Loop(Socket socket, UdpSenders senders, ReceiveGate gate)
    {
        byte[] buffer = GC.AllocateUninitializedArray<byte>(MaxDatagram);
        var address = new SocketAddress(socket.AddressFamily);
        while (true)
        {
            int count = socket.ReceiveFrom(buffer.AsSpan(), SocketFlags.None, address);
            Deliver(address, new ArraySegment<byte>(buffer, 0, count), senders, gate);
        }
    }

    private static async Task LoopAsync(Socket socket, UdpSenders senders, ReceiveGate gate)
    {
        byte[] buffer = GC.AllocateUninitializedArray<byte>(MaxDatagram, pinned: true);
        var address = new SocketAddress(socket.AddressFamily);
        while (true)
        {
            int count = await socket.ReceiveFromAsync(buffer.AsMemory(), SocketFlags.None, address).ConfigureAwait(false);
            Deliver(address, new ArraySegment<byte>(buffer, 0, count), senders, gate);
        }
    }

    private static void Deliver(SocketAddress address, ArraySegment<byte> datagram, UdpSenders senders, ReceiveGate gate)
    {
        if (gate.TryEnter())
            senders.Push(address, datagram, Stopwatch.GetTimestamp());
        if (!gate.TryLeave())
            throw new OperationCanceledException();
    }
}
