using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Determines how one TCP connection waits, for the server's answer and then for its bytes. To end both waits on any thread, close the socket and then this
// object. This needs no pool thread, which a busy process may not have for a while.
internal abstract class TcpReceiver
{
    public abstract ReceiveThread Thread { get; }

    public abstract Task ConnectAsync(Socket socket, IPEndPoint remote);

    // Completes when the server closes the connection; throws when the connection fails or the socket is closed here.
    public abstract Task ReceiveAsync(Socket socket, PacketAssembler assembler);

    // Sends a whole request on any thread, while connected. Returns false if the server does not take it in time.
    public virtual bool TrySend(Socket socket, ReadOnlySpan<byte> bytes) => socket.Send(bytes, SocketFlags.None, out _) == bytes.Length;

    // Called when the link is closed, possibly several times. Code that awaits the receiver may continue inside this call.
    public abstract void Close();
}
