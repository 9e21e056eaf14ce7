using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// How one TCP connection waits, for the server's answer and then for its bytes. Closing the socket and then this, on any thread, ends both waits,
// and needs no pool thread for it: in a busy process there may be none for a while.
internal abstract class TcpReceiver
{
    public abstract ReceiveThread Thread { get; }

    public abstract Task ConnectAsync(Socket socket, IPEndPoint remote);

    // Completes when the server closes; throws when the connection fails or the socket is closed here.
    public abstract Task ReceiveAsync(Socket socket, PacketAssembler assembler);

    // When the link is closed; may come again. What awaits the receiver may go on in here.
    public abstract void Close();
}
