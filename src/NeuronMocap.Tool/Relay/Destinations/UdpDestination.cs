using System.Net;
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
        IPEndPoint endPoint = DestinationHost.Resolve(Text, Address);
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
}
