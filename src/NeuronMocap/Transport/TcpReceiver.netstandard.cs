using System.Diagnostics;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Reads on a background thread of its own: blocking receives allocate nothing on any runtime, Unity's included.
internal static class TcpReceiver
{
    private const int BufferSize = 64 * 1024;

    // Completes when the server closes; throws when the connection fails or the socket is closed here.
    public static Task ReceiveAsync(Socket socket, PacketAssembler assembler) =>
        ReceiveThread.RunAsync("NeuronMocap TCP receive", () => Receive(socket, assembler));

    private static void Receive(Socket socket, PacketAssembler assembler)
    {
        byte[] buffer = new byte[BufferSize];
        while (true)
        {
            int count = socket.Receive(buffer, 0, buffer.Length, SocketFlags.None);
            if (count == 0)
                return;

            assembler.Push(new ArraySegment<byte>(buffer, 0, count), Stopwatch.GetTimestamp());
        }
    }
}
