using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

internal static class SocketEnd
{
    // In an orderly way or not: that depends on what was under way.
    public static bool HasEnded(this Socket socket)
    {
        try
        {
            return socket.Poll(0, SelectMode.SelectRead) && socket.Receive(new byte[1]) == 0;
        }
        catch (SocketException)
        {
            return true;
        }
    }
}
