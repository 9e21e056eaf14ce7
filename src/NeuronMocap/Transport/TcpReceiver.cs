using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// How one TCP connection waits, for the server's answer and then for its bytes. Closing the socket, on any thread, ends both waits.
internal abstract class TcpReceiver
{
    // Two dozen packets at a time under load, and small enough to stay in the processor's cache.
    public const int BufferSize = 64 * 1024;

    public abstract Task ConnectAsync(Socket socket, IPEndPoint remote);

    // Completes when the server closes; throws when the connection fails or the socket is closed here.
    public abstract Task ReceiveAsync(Socket socket, PacketAssembler assembler);

    // When the link is closed; may come again.
    public virtual void Release()
    {
    }
}
