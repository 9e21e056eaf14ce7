using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Waits on its own thread. The system wakes only that thread, and blocking receives allocate nothing on any runtime, including Unity's. No operation on
// this socket may ever be asynchronous: on .NET the socket then stays non-blocking internally. Every receive that has to wait would then use other threads
// and allocate.
internal sealed class BlockingTcpReceiver(Action? released = null) : TcpReceiver
{
    // An ordinary server never has ten frames ready at once. For a server that sends as fast as it can, the buffer grows to the largest size.
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

            // More bytes are waiting than the buffer holds, so use fewer, larger receives from now on. One long stall of a handler is enough for that. The
            // connection then keeps the memory.
            if (count == buffer.Length && count < LargestBuffer)
                buffer = new byte[2 * count];
        }
    }
}
