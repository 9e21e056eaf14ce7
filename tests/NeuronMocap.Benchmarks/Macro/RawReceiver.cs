using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Benchmarks.Macro;

// The floor of all network cases: blocking receives into one buffer, without parsing.
internal static class RawReceiver
{
    public const int BufferSize = 256 * 1024;

    public static Socket Connect(int port)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        socket.Connect(IPAddress.Loopback, port);
        return socket;
    }
}
