using System.Diagnostics.CodeAnalysis;
using System.Net;

namespace NeuronMocap.Tool.Arguments;

/// <summary>What a source without an option in front of it means: HOST, HOST:PORT, tcp://HOST[:PORT] or udp://[ADDRESS]:PORT.</summary>
/// <param name="Server">The TCP server; null for UDP.</param>
/// <param name="UdpPort">The UDP port; null for TCP.</param>
/// <param name="LocalAddress">The address of this computer to receive on, which only udp:// names; null for all of them.</param>
internal readonly record struct SourceAddress(ServerAddress? Server, int? UdpPort, IPAddress? LocalAddress)
{
    private const string Tcp = "tcp://";
    private const string Udp = "udp://";

    public static bool TryParse(string text, out SourceAddress source, [NotNullWhen(false)] out string? error)
    {
        string trimmed = text.Trim().TrimEnd('/');
        if (trimmed.StartsWith(Udp, StringComparison.OrdinalIgnoreCase))
            return TryParseUdp(trimmed[Udp.Length..], out source, out error);

        bool isTcp = trimmed.StartsWith(Tcp, StringComparison.OrdinalIgnoreCase);
        bool isServer = ServerAddress.TryParse(isTcp ? trimmed[Tcp.Length..] : trimmed, out ServerAddress server, out error);
        if (!isServer && trimmed.Contains("://", StringComparison.Ordinal))
            error = $"'{text}' is no source: give HOST, HOST:PORT, tcp://HOST:PORT or udp://:PORT.";

        source = new SourceAddress(server, UdpPort: null, LocalAddress: null);
        return isServer;
    }

    private static bool TryParseUdp(string text, out SourceAddress source, [NotNullWhen(false)] out string? error)
    {
        source = default;
        error = null;
        int colon = text.LastIndexOf(':');
        string host = colon < 0 ? text : text[..colon];
        if (colon < 0 || !ServerAddress.TryParsePort(text[(colon + 1)..], out int port))
        {
            error = $"'{Udp}{text}' has no port: give {Udp}:PORT with a port from 1 to {IPEndPoint.MaxPort}, the port of this computer to receive on.";
            return false;
        }

        IPAddress? address = null;
        if (host.Length > 0 && !IPAddress.TryParse(host.Trim('[', ']'), out address))
        {
            error = $"'{host}' is no address of this computer. Over UDP the server sends to this computer: give {Udp}:{port}.";
            return false;
        }

        source = new SourceAddress(Server: null, port, address);
        return true;
    }
}
