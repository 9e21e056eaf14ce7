using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

internal static class FreePort
{
    // The vendor's functions require a port number and do not return one. It is unlikely that another program takes the port in between.
    public static int Udp()
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        return ((IPEndPoint)socket.LocalEndPoint!).Port;
    }
}
