using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Relay.Destinations;

namespace NeuronMocap.Tool.Relay;

/// <summary>Finds a destination that would feed the source.</summary>
internal static class RelayLoop
{
    /// <summary>Whether packets that go to the destination come back from the source.</summary>
    public static bool Exists(Source source, Destination destination) => (source, destination) switch
    {
        ({ Server: { } server }, TcpDestination tcp) => server.Port == tcp.EndPoint.Port && IsOwn(server.Host, tcp.EndPoint.Address),
        ({ WebSocket: { } server }, WebSocketDestination web) => server.Port == web.EndPoint.Port && IsOwn(server.Host, web.EndPoint.Address),
        ({ UdpPort: { } port }, UdpDestination udp) => port == udp.Address.Port && IsOwn(udp.Address.Host, source.LocalAddress ?? IPAddress.Any),
        ({ UdpPort: { } port }, PoseDestination pose) => port == pose.Address.Port && IsOwn(pose.Address.Host, source.LocalAddress ?? IPAddress.Any),
        ({ VmcPort: { } port }, VmcDestination vmc) => port == vmc.Address.Port && IsOwn(vmc.Address.Host, source.LocalAddress ?? IPAddress.Any),
        ({ Broker: { } broker }, RabbitMqDestination published) => published.Reaches(broker),
        ({ File: { } file }, { File: { } output }) => SameFile.IsSame(file, output),
        _ => false,
    };

    // Whether a host is an address of this computer that the given address receives. A name other than localhost is not looked up.
    private static bool IsOwn(string host, IPAddress receiving)
    {
        IPAddress? address = host.Equals("localhost", StringComparison.OrdinalIgnoreCase) ? IPAddress.Loopback
            : IPAddress.TryParse(host, out IPAddress? given) ? given : null;
        if (address is null)
            return false;

        bool isAny = receiving.Equals(IPAddress.Any) || receiving.Equals(IPAddress.IPv6Any);
        return receiving.Equals(address) || (isAny && IsOfThisComputer(address));
    }

    // Only addresses of this computer can be bound.
    private static bool IsOfThisComputer(IPAddress address)
    {
        try
        {
            using var socket = new Socket(address.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
            socket.Bind(new IPEndPoint(address, 0));
            return true;
        }
        catch (SocketException)
        {
            return false;
        }
    }
}
