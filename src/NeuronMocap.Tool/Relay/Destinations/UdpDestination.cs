using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Simulate;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>udp://HOST:PORT: sends each packet as one datagram, whether or not somebody receives it.</summary>
/// <param name="Text">The argument of the command line.</param>
/// <param name="Address">The computer and its port.</param>
internal sealed record UdpDestination(string Text, ServerAddress Address) : Destination(Text)
{
    public const string Scheme = "udp://";

    public static UdpDestination Parse(string text)
    {
        try
        {
            ServerAddress address = ServerAddress.ParseDestination(text[Scheme.Length..]);
            return new UdpDestination(text, address);
        }
        catch (FormatException fault)
        {
            throw new FormatException($"'{text}' names no computer and port to send to. Use udp://HOST:PORT.", fault);
        }
    }

    public override bool IsSame(Destination other) => other is UdpDestination udp && udp.Address == Address;

    public override Outlet Open(NeuronReader reader, bool overwrite)
    {
        IPEndPoint endPoint = Resolve();
        try
        {
            var options = new BroadcasterOptions { Port = null, UdpDestinations = [endPoint] };
            return BroadcastOutlet.Start(reader, options, _ => Text);
        }
        catch (BroadcasterException exception)
        {
            throw new RelayException(StartFailure.DescribeArgument(exception, Text, endPoint));
        }
    }

    // IPv4 first, because the vendor's readers bind only to IPv4 (protocol.md section 4.2).
    private IPEndPoint Resolve()
    {
        if (IPAddress.TryParse(Address.Host, out IPAddress? address))
            return new IPEndPoint(address, Address.Port);

        try
        {
            IPAddress[] addresses = Dns.GetHostAddresses(Address.Host);
            return new IPEndPoint(addresses.OrderBy(static candidate => candidate.AddressFamily != AddressFamily.InterNetwork).First(), Address.Port);
        }
        catch (SocketException exception)
        {
            throw new RelayException($"{Text}: the host name {Address.Host} has no address ({exception.SocketErrorCode}).");
        }
    }
}
