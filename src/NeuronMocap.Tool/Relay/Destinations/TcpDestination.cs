using System.Globalization;
using System.Net;
using NeuronMocap.Server;
using NeuronMocap.Tool.Simulate;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>tcp://[ADDRESS]:PORT: listens for clients, as a server does.</summary>
/// <param name="Text">The argument of the command line.</param>
/// <param name="EndPoint">Address and port to listen on. Without an address, all addresses of this computer.</param>
internal sealed record TcpDestination(string Text, IPEndPoint EndPoint) : Destination(Text)
{
    public const string Scheme = "tcp://";

    public override IPEndPoint Listening => EndPoint;

    public static TcpDestination Parse(string text) => new(text, ParseListening(text, Scheme, IPAddress.Any));

    /// <summary>Parses SCHEME[ADDRESS]:PORT.</summary>
    /// <param name="text">The argument of the command line.</param>
    /// <param name="scheme">The scheme with which it begins.</param>
    /// <param name="usual">The address to listen on if the argument has none.</param>
    /// <exception cref="FormatException">The text has no port, or its address is not one.</exception>
    public static IPEndPoint ParseListening(string text, string scheme, IPAddress usual)
    {
        string rest = text[scheme.Length..].TrimEnd('/');
        int colon = rest.LastIndexOf(':');
        bool isPort = ushort.TryParse(rest.AsSpan(colon + 1), NumberStyles.None, CultureInfo.InvariantCulture, out ushort port);
        string host = colon < 0 ? rest : rest[..colon];
        if (colon < 0 || !isPort)
            throw new FormatException($"'{text}' has no port to listen on. Use {scheme}:PORT, with a port from 0 to {IPEndPoint.MaxPort}; 0 takes any free port.");
        if (host.Length == 0)
            return new IPEndPoint(usual, port);

        return IPAddress.TryParse(host, out IPAddress? address)
            ? new IPEndPoint(address, port)
            : throw new FormatException(
                $"'{host}' in '{text}' is not an address. A destination {scheme} listens on an address of this computer; without one, on "
                + (usual.Equals(IPAddress.Any) ? "all." : $"{usual}."));
    }

    public override bool IsSame(Destination other) => other is TcpDestination tcp && Clashes(EndPoint, tcp.EndPoint);

    /// <summary>Whether one of two end points to listen on makes the other unavailable.</summary>
    public static bool Clashes(IPEndPoint one, IPEndPoint other) => one.Port == other.Port && one.Port != 0
        && (IsAny(one.Address) || IsAny(other.Address) || one.Address.Equals(other.Address));

    public override Outlet Open(NeuronReader reader, bool overwrite)
    {
        try
        {
            var options = new BroadcasterOptions { BindAddress = EndPoint.Address, Port = EndPoint.Port };
            return BroadcastOutlet.Start(reader, options, static broadcaster => $"{Scheme}{broadcaster.LocalEndPoint}");
        }
        catch (BroadcasterException exception)
        {
            throw new RelayException(StartFailure.DescribeArgument(exception, Text, EndPoint));
        }
    }

    private static bool IsAny(IPAddress address) => address.Equals(IPAddress.Any) || address.Equals(IPAddress.IPv6Any);
}
