using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class TcpConnector
{
    public static Task ConnectAsync(Socket socket, IPEndPoint remote) => socket.ConnectAsync(remote);
}
