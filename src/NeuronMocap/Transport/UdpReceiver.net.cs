using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class UdpReceiver
{
    private const int MaxDatagram = 65_536;

    // Never completes; throws when the socket is closed or fails.
    public static async Task ReceiveAsync(Socket socket, UdpSenders senders)
    {
        byte[] buffer = GC.AllocateUninitializedArray<byte>(MaxDatagram, pinned: true);
        var address = new SocketAddress(socket.AddressFamily);
        while (true)
        {
            int count = await socket.ReceiveFromAsync(buffer.AsMemory(), SocketFlags.None, address).ConfigureAwait(false);
            senders.Push(address, new ArraySegment<byte>(buffer, 0, count), Stopwatch.GetTimestamp());
        }
    }
}
