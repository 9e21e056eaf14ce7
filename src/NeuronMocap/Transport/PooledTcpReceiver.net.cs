using System.Buffers;
using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Waits without a thread and, while nothing arrives, without memory. This suits a process with very many connections. The bytes are handled on the pool
// thread on which the system's completion arrives.
internal sealed class PooledTcpReceiver : TcpReceiver
{
    private const int BufferSize = 64 * 1024;

    private readonly ReceiveGate _lock = new();

    public override ReceiveThread Thread => ReceiveThread.Pool;

    public override Task ConnectAsync(Socket socket, IPEndPoint remote) => _lock.UntilClosedAsync(socket.ConnectAsync(remote));

    public override Task ReceiveAsync(Socket socket, PacketAssembler assembler) => _lock.UntilClosedAsync(LoopAsync(socket, assembler));

    public override void Close() => _lock.Close();

    // One method, so there is one state machine for the whole connection. A separate one for each arrival would be allocated at every wait.
    private async Task LoopAsync(Socket socket, PacketAssembler assembler)
    {
        int count;
        do
        {
            // A receive of zero bytes completes as soon as there are bytes. It can also complete for bytes that the last receive already took, because the
            // system's notice of them came later. A receive would then wait with its buffer.
            await socket.ReceiveAsync(Memory<byte>.Empty, SocketFlags.None).ConfigureAwait(false);
            count = 1;
            if (socket.Available == 0 && !socket.Poll(0, SelectMode.SelectRead))
                continue;

            byte[] buffer = ArrayPool<byte>.Shared.Rent(BufferSize);
            try
            {
                do
                {
                    count = await socket.ReceiveAsync(buffer.AsMemory(0, BufferSize), SocketFlags.None).ConfigureAwait(false);
                    if (count > 0 && _lock.TryEnter())
                        assembler.Push(new ArraySegment<byte>(buffer, 0, count), Stopwatch.GetTimestamp());
                    if (count > 0 && !_lock.TryLeave())
                        return;
                }
                while (count == BufferSize);
            }
            finally
            {
                ArrayPool<byte>.Shared.Return(buffer);
            }
        }
        while (count > 0);
    }
}
