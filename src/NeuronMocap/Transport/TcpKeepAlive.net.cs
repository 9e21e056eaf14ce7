using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class TcpKeepAlive
{
    // A peer that loses its power or its network sends nothing more. A computer that only listens would wait forever. Sends probes after 10 s of silence,
    // every 2 s, and gives up after 5 probes without an answer.
    public static void Enable(Socket socket)
    {
        try
        {
            socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.KeepAlive, optionValue: true);
            socket.SetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveTime, 10);
            socket.SetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveInterval, 2);
            socket.SetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveRetryCount, 5);
        }
        catch (SocketException)
        {
            // Not every system has all of these options; without them a dead peer is noticed later.
        }
    }
}
