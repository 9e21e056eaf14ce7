using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class TcpConnect
{
    // Blocks until the connection is established or fails; closing the socket ends it at once.
    public static void Run(Socket socket, EndPoint remote) => socket.Connect(remote);
}
