using System.Globalization;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

// Parses addresses in the form used on command lines: HOST, HOST:PORT, ADDRESS, [IPV6]:PORT.
internal static class AddressText
{
    private const string TcpScheme = "tcp://";
    private const string UdpScheme = "udp://";
    private const string TlsScheme = "tls://";

    /// <summary>Parses the address of a server, with or without a leading tcp://, or with a leading tls:// if <see cref="IsEncrypted"/>.</summary>
    /// <exception cref="FormatException">The text is not an address; the message says why.</exception>
    public static (string Host, int Port) ParseServer(string text, int defaultPort, bool isEncrypted = false)
    {
        string scheme = isEncrypted ? TlsScheme : TcpScheme;
        string word = text.Trim();
        if (HasScheme(word, scheme))
            word = word[scheme.Length..];

        (string host, string? port) = Split(word.TrimEnd('/'));
        if (host.Length == 0 || word.Contains("://", StringComparison.Ordinal) || host.Any(IsNotOfHost))
            throw new FormatException($"'{text}' is not an address. Use HOST or HOST:PORT, and [ADDRESS]:PORT for IPv6.");
        if (host.Contains(':', StringComparison.Ordinal) && !(IPAddress.TryParse(host, out IPAddress? address) && address.AddressFamily == AddressFamily.InterNetworkV6))
            throw new FormatException($"'{host}' is not an IPv6 address. Use HOST, HOST:PORT or [IPV6]:PORT.");

        return (host, port is null ? defaultPort : ParsePort(text, port, lowest: 1));
    }

    /// <summary>Parses udp://:PORT and udp://ADDRESS:PORT; the address must be one of this computer.</summary>
    /// <returns>The port, and the address or null for all addresses. Null if the text does not begin with udp://.</returns>
    /// <exception cref="FormatException">The text begins with udp:// but is not an address; the message says why.</exception>
    public static (int Port, IPAddress? LocalAddress)? ParseUdp(string text)
    {
        string word = text.Trim();
        if (!HasScheme(word, UdpScheme))
            return null;

        (string host, string? port) = Split(word[UdpScheme.Length..].TrimEnd('/'));
        if (port is null)
            throw new FormatException($"'{text}' has no port. Use udp://:PORT with the port of this computer that the server sends to.");

        // Zero means any free port.
        int number = ParsePort(text, port, lowest: 0);
        IPAddress? address = null;
        if (host.Length > 0 && !IPAddress.TryParse(host, out address))
            throw new FormatException($"'{host}' is not an address of this computer. Over UDP the server sends to this computer: use udp://:{number}.");

        return (number, address);
    }

    /// <summary>
    /// Whether an option for a host also has a port or a scheme. <see cref="IPAddress"/> would accept [::1]:7001 and ignore the port. An IPv6 address without
    /// brackets has at least two colons.
    /// </summary>
    public static bool HasPort(string host) => host is ['[', ..]
        ? host.IndexOf(']') != host.Length - 1
        : host.IndexOf(':') is >= 0 and var colon && host.LastIndexOf(':') == colon;

    /// <summary>Whether the text begins with tls://.</summary>
    public static bool IsEncrypted(string text) => HasScheme(text.Trim(), TlsScheme);

    private static bool HasScheme(string word, string scheme) => word.StartsWith(scheme, StringComparison.OrdinalIgnoreCase);

    private static bool IsNotOfHost(char character) =>
        character is '[' or ']' or '/' or '\\' || char.IsWhiteSpace(character) || char.IsControl(character);

    // A word with two colons and no brackets is an IPv6 address without a port.
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

    private static int ParsePort(string text, string port, int lowest)
    {
        if (int.TryParse(port, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= lowest && number <= IPEndPoint.MaxPort)
            return number;

        throw new FormatException(
            $"{(port.Length == 0 ? $"'{text}' has no number after the colon" : $"'{port}' in '{text}' is not a port")}. A port is a number from 1 to {IPEndPoint.MaxPort}.");
    }
}
