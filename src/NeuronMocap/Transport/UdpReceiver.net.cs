using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class UdpReceiver
{
    private const int MaxDatagram = 65_536;

    // Throws when the gate or the socket is closed, or the socket fails.
    public static Task ReceiveAsync(Socket socket, UdpSenders senders, ReceiveGate gate) => gate.UntilClosedAsync(LoopAsync(socket, senders, gate));

    private static async Task LoopAsync(Socket socket, UdpSenders senders, ReceiveGate gate)
    {
        byte[] buffer = GC.AllocateUninitializedArray<byte>(MaxDatagram, pinned: true);
        var address = new SocketAddress(socket.AddressFamily);
        while (true)
        {
            int count = await socket.ReceiveFromAsync(buffer.AsMemory(), SocketFlags.None, address).ConfigureAwait(false);
            if (gate.TryEnter())
                senders.Push(address, new ArraySegment<byte>(buffer, 0, count), Stopwatch.GetTimestamp());
            if (!gate.TryLeave())
                throw new OperationCanceledException();
        }
    }
}
