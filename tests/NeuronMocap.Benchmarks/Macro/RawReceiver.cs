using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Benchmarks.Macro;

// The floor of all that comes over a network: blocking receives into one buffer, nothing parsed.
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
