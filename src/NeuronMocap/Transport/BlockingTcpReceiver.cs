using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Waits on a thread of its own: the system wakes that thread and no other, and blocking receives allocate nothing on any runtime, Unity's
// included. Nothing on this socket may ever be asynchronous: on .NET it is then non-blocking underneath for ever after, and every receive
// that has to wait goes over other threads and allocates.
internal sealed class BlockingTcpReceiver(Action? released = null) : TcpReceiver
{
    // Ten frames at once are more than an ordinary server ever has ready; one that sends as fast as it can gets up to the largest.
    private const int SmallestBuffer = 16 * 1024;
    private const int LargestBuffer = 256 * 1024;

    private Action? _released = released;

    public override ReceiveThread Thread => ReceiveThread.Dedicated;

    public override Task ConnectAsync(Socket socket, IPEndPoint remote) =>
        DedicatedThread.RunAsync("NeuronMocap TCP connect", () => TcpConnect.Run(socket, remote), TaskCreationOptions.None);

    public override Task ReceiveAsync(Socket socket, PacketAssembler assembler) =>
        DedicatedThread.RunAsync("NeuronMocap TCP receive", () => Receive(socket, assembler), TaskCreationOptions.None);

    public override void Close() => Interlocked.Exchange(ref _released, null)?.Invoke();

    private static void Receive(Socket socket, PacketAssembler assembler)
    {
        byte[] buffer = new byte[SmallestBuffer];
        while (true)
        {
            int count = socket.Receive(buffer, 0, buffer.Length, SocketFlags.None);
            if (count == 0)
                return;

            assembler.Push(new ArraySegment<byte>(buffer, 0, count), Stopwatch.GetTimestamp());

            // More is waiting than there is room for: fewer, larger receives from here on. One long stall of a handler is enough for that; the
            // memory then stays the connection's.
            if (count == buffer.Length && count < LargestBuffer)
                buffer = new byte[2 * count];
        }
    }
}
