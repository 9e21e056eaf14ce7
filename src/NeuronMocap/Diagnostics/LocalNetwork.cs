using System.Net;
using System.Net.NetworkInformation;
using System.Net.Sockets;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// The networks of this computer.
internal static class LocalNetwork
{
    private readonly record struct OwnAddress(IPAddress Address, int PrefixLength, string Network);

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

    public static string DescribeRoute(IPAddress local, IPAddress remote)
    {
        if (IPAddress.IsLoopback(remote))
            return $"from {local}, inside this computer";

        OwnAddress own = OwnAddresses().FirstOrDefault(own => own.Address.Equals(local));
        if (own.Address is null)
            return $"from {local}";

        string where = IsInNetwork(remote, own) ? "on the same network" : "through a router: not on the same network";
        return $"from {local} ({own.Network}), {where}";
    }

    // The addresses to which other computers can send.
    public static IReadOnlyList<string> ReachableAddresses() =>
        [.. OwnAddresses().Where(static own => own.Address.AddressFamily == AddressFamily.InterNetwork && !IPAddress.IsLoopback(own.Address))
            .Select(static own => own.Address.ToString()).Take(4)];

    private static bool IsInNetwork(IPAddress address, OwnAddress own)
    {
        byte[] left = address.GetAddressBytes();
        byte[] right = own.Address.GetAddressBytes();
        if (left.Length != right.Length)
            return false;

        for (int bit = 0; bit < own.PrefixLength; bit++)
        {
            int mask = 0x80 >> (bit % 8);
            if (((left[bit / 8] ^ right[bit / 8]) & mask) != 0)
                return false;
        }

        return true;
    }

    // Unity's runtimes lack parts of this. The result is only shown, never needed.
    private static List<OwnAddress> OwnAddresses()
    {
        try
        {
            return
            [
                .. NetworkInterface.GetAllNetworkInterfaces()
                    .Where(static network => network.OperationalStatus is OperationalStatus.Up or OperationalStatus.Unknown)
                    .SelectMany(static network => network.GetIPProperties().UnicastAddresses
                        .Select(address => new OwnAddress(address.Address, address.PrefixLength, network.Name))),
            ];
        }
        catch (Exception exception) when (exception is NetworkInformationException or PlatformNotSupportedException or NotImplementedException)
        {
            // Not every runtime and system lists its networks; Unity's players do not. The diagnosis then continues and says less about the route.
            return [];
        }
    }
}
