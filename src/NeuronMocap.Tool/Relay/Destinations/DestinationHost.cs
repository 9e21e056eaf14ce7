using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>Looks up the computer that a destination names.</summary>
internal static class DestinationHost
{
    /// <summary>Gets the address and port. IPv4 comes first, because the vendor's readers bind only to IPv4 (protocol.md section 4.2).</summary>
    /// <param name="text">The argument of the command line, for the message.</param>
    /// <param name="address">The computer and its port.</param>
    /// <exception cref="RelayException">The host name has no address.</exception>
    public static IPEndPoint Resolve(string text, ServerAddress address)
    {
        if (IPAddress.TryParse(address.Host, out IPAddress? literal))
            return new IPEndPoint(literal, address.Port);

        try
        {
            IPAddress[] addresses = Dns.GetHostAddresses(address.Host);
            return new IPEndPoint(addresses.OrderBy(static candidate => candidate.AddressFamily != AddressFamily.InterNetwork).First(), address.Port);
        }
        catch (SocketException exception)
        {
            throw new RelayException($"{text}: the host name {address.Host} has no address ({exception.SocketErrorCode}).");
        }
        catch (ArgumentException)
        {
            throw new RelayException($"{text}: no computer can have this name. It is too long.");
        }
    }
}
