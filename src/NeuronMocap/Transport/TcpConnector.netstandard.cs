using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class TcpConnector
{
    // On .NET a socket that has once connected asynchronously is non-blocking underneath for ever after, and every blocking receive that has
    // to wait then allocates. Closing the socket ends the wait. On a thread of its own: several that wait for addresses that do not answer
    // would keep the pool's threads from everything else, the stopping of readers included.
    public static Task ConnectAsync(Socket socket, IPEndPoint remote) =>
        ReceiveThread.RunAsync("NeuronMocap TCP connect", () => socket.Connect(remote));
}
