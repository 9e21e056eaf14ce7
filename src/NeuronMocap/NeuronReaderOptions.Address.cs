using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <content>Options from an address as people write it.</content>
public sealed partial class NeuronReaderOptions
{
    /// <summary>
    /// Makes options for an address as people write it on a command line or in a settings dialog. It sets <see cref="Transport"/>, <see cref="Host"/>,
    /// <see cref="Port"/> and <see cref="LocalAddress"/>; everything else keeps its default.
    /// </summary>
    /// <param name="address">
    /// <c>HOST</c>, <c>HOST:PORT</c> or <c>tcp://HOST:PORT</c> for a TCP server, port 7001 unless given; <c>udp://:PORT</c> or <c>udp://LOCALADDRESS:PORT</c>
    /// to receive over UDP, where port 0 takes any free port. An IPv6 address with a port stands in brackets: <c>[::1]:7001</c>.
    /// </param>
    /// <returns>New options.</returns>
    /// <exception cref="FormatException">The text is not an address; the message says why, in words for the person who wrote it.</exception>
    public static NeuronReaderOptions Parse(string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        if (AddressText.ParseUdp(address) is (int udpPort, var localAddress))
            return new NeuronReaderOptions { Transport = TransportKind.Udp, Port = udpPort, LocalAddress = localAddress };

        (string host, int port) = AddressText.ParseServer(address, ProtocolConstants.DefaultPort);
        return new NeuronReaderOptions { Host = host, Port = port };
    }
}
