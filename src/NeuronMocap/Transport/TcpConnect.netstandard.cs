using System.Net;
using System.Net.Sockets;
using System.Runtime.InteropServices;

namespace NeuronMocap.Transport;

internal static class TcpConnect
{
    // Longest time that a close of the socket must wait.
    private const int PollMicroseconds = 10_000;

    // .NET would never make the socket blocking again, and it closes a connecting socket at once.
    private static readonly bool IsDotNet = RuntimeInformation.FrameworkDescription.StartsWith(".NET ", StringComparison.Ordinal);

    // Blocks until the connection is established or fails; closing the socket ends it at once. Mono, and therefore Unity, needs a second to close a socket
    // that is blocked in a connect.
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
