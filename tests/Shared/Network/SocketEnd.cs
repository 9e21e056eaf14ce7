using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

internal static class SocketEnd
{
    // Gracefully or by a reset, depending on the data in transit.
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
