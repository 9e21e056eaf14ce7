using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class TcpKeepAlive
{
    // A peer whose computer lost its power or its network says nothing more, and whoever only listens would wait for ever.
    // Probes after 10 s of silence, every 2 s; given up after 5 without an answer.
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
            // Not every system has all of these; without them a dead peer is noticed later.
        }
    }
}
