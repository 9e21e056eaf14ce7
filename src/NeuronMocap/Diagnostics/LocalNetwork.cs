using System.Net;
using System.Net.Sockets;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// The networks of this computer.
internal static class LocalNetwork
{
    // Finds the address from which the system would send to another address. Connecting a datagram socket makes the system choose, and sends nothing.
    public static ConnectionReason FindRoute(IPAddress remote, int port, IPAddress? bound, out IPAddress? local)
    {
        local = null;
        if (bound is not null && bound.AddressFamily != remote.AddressFamily)
            return ConnectionReason.AddressUnavailable;

        try
        {
            using var socket = new Socket(remote.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
            if (bound is not null)
                socket.Bind(new IPEndPoint(bound, 0));

            socket.Connect(new IPEndPoint(remote, port));
            local = ((IPEndPoint)socket.LocalEndPoint!).Address;
            return ConnectionReason.None;
        }
        catch (SocketException exception)
        {
            return SocketErrors.ToReason(exception.SocketErrorCode);
        }
    }

    public static string DescribeRoute(IReadOnlyList<OwnNetwork> networks, IPAddress local, IPAddress remote)
    {
        if (IPAddress.IsLoopback(remote))
            return $"from {local}, inside this computer";

        OwnNetwork own = networks.FirstOrDefault(own => local.Equals(own.Address));
        if (own.Address is null)
            return $"from {local}";

        string where = own.Contains(remote) ? ", on the same network"
            : own.HasNeighbours ? ", through a router: not on the same network"
            : string.Empty;
        return $"from {local} ({own.Name}){where}";
    }

    // The addresses to which other computers can send.
    public static IReadOnlyList<IPAddress> ReachableAddresses() =>
        [.. OwnNetwork.FindAll().Where(static own => own.Address?.AddressFamily == AddressFamily.InterNetwork && !own.IsLoopback)
            .Select(static own => own.Address!).Take(4)];
}
