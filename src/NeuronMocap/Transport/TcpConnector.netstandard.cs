using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class TcpConnector
{
    // On .NET a socket that has once connected asynchronously is non-blocking underneath for ever after, and every blocking receive that has
    // to wait then allocates. Closing the socket ends the wait.
    public static Task ConnectAsync(Socket socket, IPEndPoint remote) => Task.Run(() => socket.Connect(remote));
}
