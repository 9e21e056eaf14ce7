using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Server.Tests;

internal static class Broadcasts
{
    public static Broadcaster Started(BroadcasterOptions options)
    {
        var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        return broadcaster;
    }

    // A UDP port with room for everything that a test sends. Nothing is lost while the socket's buffer is not full.
    public static Socket Receiver()
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = 1_000_000 };
        socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        return socket;
    }
}
