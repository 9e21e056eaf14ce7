using System.Diagnostics.CodeAnalysis;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Where frames come from.</summary>
internal enum SourceKind
{
    /// <summary>A simulator inside this process.</summary>
    Demo,

    /// <summary>A server, over TCP.</summary>
    Tcp,

    /// <summary>A port of this computer, over UDP.</summary>
    Udp,

    /// <summary>A recording, or the bytes of a stream.</summary>
    File,
}

/// <summary>What the word SOURCE means: HOST, HOST:PORT, tcp://HOST[:PORT], udp://[ADDRESS]:PORT, a file, or demo.</summary>
/// <param name="Kind">What it is.</param>
internal sealed record Source(SourceKind Kind)
{
    /// <summary>How a source is written, for help and for errors.</summary>
    public const string Forms = "HOST, HOST:PORT, tcp://HOST:PORT, udp://:PORT, a file, or demo";

    private const string DemoWord = "demo";
    private const string TcpScheme = "tcp://";
    private const string UdpScheme = "udp://";

    /// <summary>The simulator inside this process.</summary>
    public static Source Demo { get; } = new(SourceKind.Demo);

    /// <summary>The server; null for all but TCP.</summary>
    public ServerAddress? Server { get; private init; }

    /// <summary>The port of this computer; null for all but UDP.</summary>
    public int? UdpPort { get; private init; }

    /// <summary>The address of this computer to receive on, which only udp:// names; null for all of them.</summary>
    public IPAddress? LocalAddress { get; private init; }

    /// <summary>The file, as it was written; null for all but a file.</summary>
    public string? File { get; private init; }

    public static Source OfServer(ServerAddress server) => new(SourceKind.Tcp) { Server = server };

    public static Source OfUdp(int port, IPAddress? localAddress = null) => new(SourceKind.Udp) { UdpPort = port, LocalAddress = localAddress };

    public static Source OfFile(string path) => new(SourceKind.File) { File = path };

    /// <summary>Reads a source.</summary>
    /// <param name="text">A word of the command line.</param>
    /// <param name="source">What it means.</param>
    /// <param name="error">Why it means nothing.</param>
    /// <param name="defaultPort">The port of a server that is named without one.</param>
    public static bool TryParse(
        string text,
        [NotNullWhen(true)] out Source? source,
        [NotNullWhen(false)] out string? error,
        int defaultPort = ProtocolConstants.DefaultPort)
    {
        (source, error) = Parse(text, defaultPort);
        return source is not null;
    }

    /// <summary>As it is written on the command line, with the transport and the port.</summary>
    public override string ToString() => Kind switch
    {
        SourceKind.Tcp => $"{TcpScheme}{Server}",
        SourceKind.Udp => $"{UdpScheme}{(LocalAddress is null ? string.Empty : new IPEndPoint(LocalAddress, 0).ToString()[..^2])}:{UdpPort}",
        SourceKind.File => File!,
        _ => DemoWord,
    };

    private static (Source? Source, string? Error) Parse(string text, int defaultPort)
    {
        string word = text.Trim();
        string trimmed = word.TrimEnd('/');
        if (trimmed.StartsWith(UdpScheme, StringComparison.OrdinalIgnoreCase))
            return ParseUdp(trimmed[UdpScheme.Length..]);
        if (trimmed.StartsWith(TcpScheme, StringComparison.OrdinalIgnoreCase))
            return ParseServer(trimmed[TcpScheme.Length..], text, defaultPort);
        if (word.Contains("://", StringComparison.Ordinal) || word.Length == 0)
            return (null, IsNone(text));
        if (word.Equals(DemoWord, StringComparison.OrdinalIgnoreCase))
            return (Demo, null);

        return IsFileName(word) ? (OfFile(text), null) : ParseServer(trimmed, text, defaultPort);
    }

    // A computer may have the name of a file: tcp://take.bin is one.
    private static bool IsFileName(string word) =>
        word.AsSpan().TrimEnd('/').ContainsAny('/', '\\') || FileKinds.OfName(word) is not null || System.IO.File.Exists(word);

    private static (Source? Source, string? Error) ParseServer(string host, string text, int defaultPort)
    {
        if (ServerAddress.TryParse(host, out ServerAddress server, out string? error, defaultPort))
            return (OfServer(server), null);

        return (null, host.Length == 0 ? IsNone(text) : error);
    }

    private static (Source? Source, string? Error) ParseUdp(string text)
    {
        int colon = text.LastIndexOf(':');
        string host = colon < 0 ? text : text[..colon];
        string number = text[(colon + 1)..];
        if (colon >= 0 && number.Length > 0 && number.All(char.IsAsciiDigit) && !ServerAddress.TryParsePort(number, out _))
            return (null, ServerAddress.IsNoPort(number));
        if (colon < 0 || !ServerAddress.TryParsePort(number, out int port))
            return (null, $"'{UdpScheme}{text}' has no port: give {UdpScheme}:PORT with a port from 1 to {IPEndPoint.MaxPort}, the port of this computer to receive on.");

        IPAddress? address = null;
        return host.Length > 0 && !IPAddress.TryParse(host.Trim('[', ']'), out address)
            ? (null, $"'{host}' is no address of this computer. Over UDP the server sends to this computer: give {UdpScheme}:{port}.")
            : (OfUdp(port, address), null);
    }

    private static string IsNone(string text) => $"'{text}' is no source: give {Forms}.";
}
