using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <content>Options from the text form of an address.</content>
public sealed partial class NeuronReaderOptions
{
    /// <summary>
    /// Makes options from an address in the form used on command lines and in settings dialogs. It sets <see cref="Transport"/>, <see cref="Host"/>,
    /// <see cref="Port"/>, <see cref="LocalAddress"/> and <see cref="Tls"/>; all other options keep their defaults.
    /// </summary>
    /// <param name="address">
    /// For a TCP server: <c>HOST</c>, <c>HOST:PORT</c> or <c>tcp://HOST:PORT</c>; the default port is 7001. <c>tls://HOST:PORT</c> for a server that
    /// encrypts its stream. To receive over UDP: <c>udp://:PORT</c> or
    /// <c>udp://LOCALADDRESS:PORT</c>; port 0 takes any free port. An IPv6 address with a port needs brackets: <c>[::1]:7001</c>.
    /// </param>
    /// <returns>New options.</returns>
    /// <exception cref="FormatException">The text is not an address; the message tells the user why.</exception>
    public static NeuronReaderOptions Parse(string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        if (AddressText.ParseUdp(address) is (int udpPort, var localAddress))
            return new NeuronReaderOptions { Transport = TransportKind.Udp, Port = udpPort, LocalAddress = localAddress };

        bool isEncrypted = AddressText.IsEncrypted(address);
        (string host, int port) = AddressText.ParseServer(address, ProtocolConstants.DefaultPort, isEncrypted);
        return new NeuronReaderOptions { Host = host, Port = port, Tls = isEncrypted ? new NeuronTlsOptions() : null };
    }
}
