using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tool.Arguments;

/// <summary>What HOST[:PORT] means. An IPv6 address stands in brackets when a port follows: [::1]:7001.</summary>
/// <param name="Host">A name or an address, without brackets.</param>
/// <param name="Port">1 to 65535.</param>
internal readonly record struct ServerAddress(string Host, int Port)
{
    public static bool TryParse(
        string text,
        out ServerAddress address,
        [NotNullWhen(false)] out string? error,
        int defaultPort = ProtocolConstants.DefaultPort)
    {
        address = default;
        (string host, string? port) = Split(text.Trim());
        error = FindFault(text, host);
        if (error is not null)
            return false;

        int number = defaultPort;
        if (port is not null && !TryParsePort(port, out number))
        {
            error = IsNoPort(port);
            return false;
        }

        address = new ServerAddress(host, number);
        return true;
    }

    public static bool TryParsePort(string text, out int port) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out port) && port is > 0 and <= IPEndPoint.MaxPort;

    public static string IsNoPort(string text) => $"'{text}' is no port: it must be a number from 1 to {IPEndPoint.MaxPort}.";

    public override string ToString() => Host.Contains(':', StringComparison.Ordinal) ? $"[{Host}]:{Port}" : $"{Host}:{Port}";

    private static (string Host, string? Port) Split(string text)
    {
        int end = text.StartsWith('[') ? text.IndexOf(']', StringComparison.Ordinal) : -1;
        if (end > 0)
        {
            string rest = text[(end + 1)..];
            return rest.Length == 0 ? (text[1..end], null) : rest[0] == ':' ? (text[1..end], rest[1..]) : (string.Empty, null);
        }

        // Two colons and no brackets: all of it is an IPv6 address.
        int colon = text.IndexOf(':', StringComparison.Ordinal);
        return colon < 0 || colon != text.LastIndexOf(':') ? (text, null) : (text[..colon], text[(colon + 1)..]);
    }

    private static string? FindFault(string text, string host)
    {
        if (host.Length == 0 || host.Any(char.IsWhiteSpace) || host.AsSpan().IndexOfAny("[]/") >= 0)
            return $"'{text}' is no server: give HOST or HOST:PORT, for an IPv6 address [ADDRESS]:PORT.";

        bool isAddress = IPAddress.TryParse(host, out IPAddress? parsed) && parsed.AddressFamily == AddressFamily.InterNetworkV6;
        return host.Contains(':', StringComparison.Ordinal) && !isAddress
            ? $"'{host}' is no IPv6 address; give HOST, HOST:PORT or [IPV6]:PORT."
            : null;
    }
}
