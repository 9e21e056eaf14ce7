using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

internal static class FreePort
{
    // The vendor's functions want a number and tell none. That another program takes the port in between would be a rare chance.
    public static int Udp()
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        return ((IPEndPoint)socket.LocalEndPoint!).Port;
    }
}
