using System.Net;
using System.Net.Sockets;
using System.Runtime.InteropServices;

namespace NeuronMocap.Transport;

internal static class TcpConnect
{
    // Longest time that closing the socket waits for.
    private const int PollMicroseconds = 10_000;

    // .NET would never let the socket block again, and closes one that is connecting at once.
    private static readonly bool IsDotNet = RuntimeInformation.FrameworkDescription.StartsWith(".NET ", StringComparison.Ordinal);

    // Blocks until there is a connection or none; closing the socket ends it at once. Mono, and so Unity, takes a second to close a socket that
    // is blocked while it connects.
    public static void Run(Socket socket, EndPoint remote)
    {
        if (IsDotNet)
            socket.Connect(remote);
        else
            Poll(socket, remote);
    }

    private static void Poll(Socket socket, EndPoint remote)
    {
        socket.Blocking = false;
        try
        {
            socket.Connect(remote);
        }
        catch (SocketException exception) when (exception.SocketErrorCode is SocketError.WouldBlock or SocketError.InProgress)
        {
            while (!socket.Poll(PollMicroseconds, SelectMode.SelectWrite) && !socket.Poll(0, SelectMode.SelectError))
            {
            }

            int error = (int)socket.GetSocketOption(SocketOptionLevel.Socket, SocketOptionName.Error);
            if (error != 0)
                throw new SocketException(error);
        }

        socket.Blocking = true;
    }
}
