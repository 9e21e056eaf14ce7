using System.Globalization;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

// Reads addresses as people write them: HOST, HOST:PORT, ADDRESS, [IPV6]:PORT.
internal static class AddressText
{
    private const string TcpScheme = "tcp://";
    private const string UdpScheme = "udp://";

    /// <summary>Reads the address of a server, with or without tcp:// before it.</summary>
    /// <exception cref="FormatException">It is none; the message says what is wrong with it.</exception>
    public static (string Host, int Port) ParseServer(string text, int defaultPort)
    {
        string word = text.Trim();
        if (HasScheme(word, TcpScheme))
            word = word[TcpScheme.Length..].TrimEnd('/');

        (string host, string? port) = Split(word);
        if (host.Length == 0 || word.Contains("://", StringComparison.Ordinal) || host.AsSpan().IndexOfAny("[]/ \t") >= 0)
            throw new FormatException($"'{text}' is not an address. Use HOST or HOST:PORT, and [ADDRESS]:PORT for IPv6.");
        if (host.Contains(':', StringComparison.Ordinal) && !(IPAddress.TryParse(host, out IPAddress? address) && address.AddressFamily == AddressFamily.InterNetworkV6))
            throw new FormatException($"'{host}' is not an IPv6 address. Use HOST, HOST:PORT or [IPV6]:PORT.");

        return (host, port is null ? defaultPort : ParsePort(text, port, lowest: 1));
    }

    /// <summary>Reads udp://:PORT and udp://ADDRESS:PORT, where the address is one of this computer.</summary>
    /// <returns>The port, and null for all addresses; null where the text does not begin with udp://.</returns>
    /// <exception cref="FormatException">It begins so and is no address; the message says what is wrong with it.</exception>
    public static (int Port, IPAddress? LocalAddress)? ParseUdp(string text)
    {
        string word = text.Trim();
        if (!HasScheme(word, UdpScheme))
            return null;

        (string host, string? port) = Split(word[UdpScheme.Length..].TrimEnd('/'));
        if (port is null)
            throw new FormatException($"'{text}' has no port. Use udp://:PORT with the port of this computer that the server sends to.");

        IPAddress? address = null;
        if (host.Length > 0 && !IPAddress.TryParse(host, out address))
            throw new FormatException($"'{host}' is not an address of this computer. Over UDP the server sends to this computer: use udp://:{port}.");

        return (ParsePort(text, port, lowest: 0), address);
    }

    private static bool HasScheme(string word, string scheme) => word.StartsWith(scheme, StringComparison.OrdinalIgnoreCase);

    // Two colons and no brackets: all of it is an IPv6 address.
    private static (string Host, string? Port) Split(string word)
    {
        int end = word.StartsWith('[') ? word.IndexOf(']', StringComparison.Ordinal) : -1;
        if (end > 0)
        {
            string rest = word[(end + 1)..];
            return rest.Length == 0 ? (word[1..end], null) : rest[0] == ':' ? (word[1..end], rest[1..]) : (string.Empty, null);
        }

        int colon = word.IndexOf(':', StringComparison.Ordinal);
        return colon < 0 || colon != word.LastIndexOf(':') ? (word, null) : (word[..colon], word[(colon + 1)..]);
    }

    private static int ParsePort(string text, string port, int lowest) =>
        int.TryParse(port, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= lowest && number <= IPEndPoint.MaxPort
            ? number
            : throw new FormatException($"'{port}' in '{text}' is not a port. A port is a number from {lowest} to {IPEndPoint.MaxPort}.");
}
