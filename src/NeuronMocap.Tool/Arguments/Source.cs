using System.Diagnostics.CodeAnalysis;
using System.Net;
using NeuronMocap.RabbitMq;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The kinds of sources.</summary>
internal enum SourceKind
{
    /// <summary>A simulator inside this process.</summary>
    Demo,

    /// <summary>A server, over TCP.</summary>
    Tcp,

    /// <summary>A server of WebSockets.</summary>
    WebSocket,

    /// <summary>A port of this computer, over UDP.</summary>
    Udp,

    /// <summary>A port of this computer for poses of another program, over VMC.</summary>
    Vmc,

    /// <summary>A stage on a RabbitMQ broker.</summary>
    RabbitMq,

    /// <summary>A recording, or the raw bytes of a stream.</summary>
    File,
}

/// <summary>
/// The meaning of SOURCE: HOST, HOST:PORT, tcp://HOST[:PORT], tls://HOST[:PORT], ws://HOST:PORT, udp://[ADDRESS]:PORT, vmc://[ADDRESS][:PORT], amqp://HOST, a file, or demo.
/// </summary>
/// <param name="Kind">The kind of the source.</param>
internal sealed record Source(SourceKind Kind)
{
    /// <summary>The forms of a source, for help and errors.</summary>
    public const string Forms = "HOST, HOST:PORT, tcp://HOST:PORT, tls://HOST:PORT, ws://HOST:PORT, udp://:PORT, vmc://:PORT, amqp://USER:PASSWORD@HOST, a file, or demo";

    /// <summary>The forms of a source that has a connection.</summary>
    public const string ConnectionForms = "HOST, HOST:PORT, tcp://HOST:PORT, tls://HOST:PORT, ws://HOST:PORT, udp://:PORT, or demo";

    /// <summary>The forms of a source over TCP.</summary>
    public const string ServerForms = "HOST, HOST:PORT, tcp://HOST:PORT or demo";

    /// <summary>The port of VMC if none is given: the usual one of programs that receive it.</summary>
    public const int DefaultVmcPort = 39539;

    /// <summary>The start of a source that receives poses over VMC.</summary>
    public const string VmcScheme = "vmc://";

    private const string DemoWord = "demo";
    private const string AmqpScheme = "amqp://";
    private const string TcpScheme = "tcp://";
    private const string TlsScheme = "tls://";
    private const string UdpScheme = "udp://";

    private static readonly string[] WebSocketSchemes = ["ws://", "wss://"];

    /// <summary>The simulator inside this process.</summary>
    public static Source Demo { get; } = new(SourceKind.Demo);

    /// <summary>The server; null unless the source is TCP.</summary>
    public ServerAddress? Server { get; private init; }

    /// <summary>Whether the connection to the server is encrypted.</summary>
    public bool IsEncrypted { get; private init; }

    /// <summary>The address of a server of WebSockets; null for other sources.</summary>
    public Uri? WebSocket { get; private init; }

    /// <summary>The port of this computer; null unless the source is UDP.</summary>
    public int? UdpPort { get; private init; }

    /// <summary>The port of this computer for poses over VMC; null for other sources.</summary>
    public int? VmcPort { get; private init; }

    /// <summary>The address of this computer to receive on, which only udp:// and vmc:// can name. Null for all addresses.</summary>
    public IPAddress? LocalAddress { get; private init; }

    /// <summary>The broker and what to receive from it; null unless the source is a broker.</summary>
    public RabbitMqSourceOptions? Broker { get; private init; }

    /// <summary>The file as given; null unless the source is a file.</summary>
    public string? File { get; private init; }

    public static Source OfServer(ServerAddress server, bool isEncrypted = false) => new(SourceKind.Tcp) { Server = server, IsEncrypted = isEncrypted };

    public static Source OfWebSocket(Uri address) => new(SourceKind.WebSocket) { WebSocket = address };

    public static Source OfUdp(int port, IPAddress? localAddress = null) => new(SourceKind.Udp) { UdpPort = port, LocalAddress = localAddress };

    public static Source OfVmc(int port, IPAddress? localAddress = null) => new(SourceKind.Vmc) { VmcPort = port, LocalAddress = localAddress };

    public static Source OfBroker(RabbitMqSourceOptions broker) => new(SourceKind.RabbitMq) { Broker = broker };

    public static Source OfFile(string path) => new(SourceKind.File) { File = path };

    /// <summary>Parses a source.</summary>
    /// <param name="text">An argument of the command line.</param>
    /// <param name="source">The source.</param>
    /// <param name="error">The reason why the text is not a source.</param>
    /// <param name="forms">The accepted forms, for the reason.</param>
    public static bool TryParse(
        string text, [NotNullWhen(true)] out Source? source, [NotNullWhen(false)] out string? error, string forms = Forms)
    {
        (source, error) = (null, null);
        try
        {
            source = Parse(text, forms);
            return true;
        }
        catch (FormatException fault)
        {
            error = fault.Message;
            return false;
        }
    }

    /// <summary>The source as on the command line, with transport and port, and without a password.</summary>
    public override string ToString() => Kind switch
    {
        SourceKind.Tcp => $"{(IsEncrypted ? TlsScheme : TcpScheme)}{Server}",
        SourceKind.WebSocket => new WebSocketSource(WebSocket!).Name,
        SourceKind.Udp => $"{UdpScheme}{AddressText}:{UdpPort}",
        SourceKind.Vmc => $"{VmcScheme}{AddressText}:{VmcPort}",
        SourceKind.RabbitMq => Broker!.ToString(),
        SourceKind.File => File!,
        _ => DemoWord,
    };

    // An IPv6 address is in brackets.
    private string AddressText => LocalAddress is null ? string.Empty : new IPEndPoint(LocalAddress, 0).ToString()[..^2];

    private static Source Parse(string text, string forms)
    {
        string word = text.Trim();
        if (word.Equals(DemoWord, StringComparison.OrdinalIgnoreCase))
            return Demo;

        if (word.StartsWith(VmcScheme, StringComparison.OrdinalIgnoreCase) && forms.Contains(VmcScheme, StringComparison.Ordinal))
            return ParseVmc(text, word[VmcScheme.Length..]);
        if (word.StartsWith(AmqpScheme, StringComparison.OrdinalIgnoreCase))
            return OfBroker(RabbitMqSourceOptions.Parse(word));

        bool hasScheme = word.Contains("://", StringComparison.Ordinal);
        bool isTransport = HasScheme(word, TcpScheme) || HasScheme(word, TlsScheme) || HasScheme(word, UdpScheme);
        if (Array.Exists(WebSocketSchemes, scheme => HasScheme(word, scheme)))
            return ParseWebSocket(text, word);
        if (word.Length == 0 || (hasScheme && !isTransport) || (!hasScheme && HiddenPassword.IsIn(word)))
            throw new FormatException($"'{HiddenPassword.In(text)}' is not a source. Use {forms}.");
        if (!hasScheme && IsFileName(word))
            return OfFile(text);
        if (!hasScheme && MistypedFile.Describe(word) is { } mistake)
            throw new FormatException(mistake);

        var options = NeuronReaderOptions.Parse(word);
        if (options.Transport == TransportKind.Tcp)
            return OfServer(new ServerAddress(options.Host, options.Port), options.Tls is not null);

        // The library takes any free port for 0. No sender would know that port.
        return options.Port > 0
            ? OfUdp(options.Port, options.LocalAddress)
            : throw new FormatException($"'{text}' has no port that a server could send to. Use udp://:PORT with a port from 1 to {IPEndPoint.MaxPort}.");
    }

    // A port of this computer is written as for udp://.
    private static Source ParseVmc(string text, string rest)
    {
        try
        {
            var options = NeuronReaderOptions.Parse(UdpScheme + (HasPort(rest) ? rest : $"{rest}:{DefaultVmcPort}"));
            if (options.Port > 0)
                return OfVmc(options.Port, options.LocalAddress);
        }
        catch (FormatException)
        {
            // The message would name another scheme.
        }

        throw new FormatException($"'{text}' has no port that a program could send to. Use vmc://:PORT with a port from 1 to {IPEndPoint.MaxPort}; the port is {DefaultVmcPort} if it is left out.");
    }

    // Only a whole address, or nothing, has no port. A number alone is meant as a port, although it could be read as an address.
    private static bool HasPort(string rest) =>
        rest.Length > 0 && !rest.EndsWith(']') && (rest.Contains(':', StringComparison.Ordinal) || !rest.Contains('.', StringComparison.Ordinal));

    // The query may hold a token.
    private static Source ParseWebSocket(string text, string word) => Uri.TryCreate(word, UriKind.Absolute, out Uri? address) && address is { Host.Length: > 0, UserInfo.Length: 0, Port: > 0 }
        ? OfWebSocket(address)
        : throw new FormatException($"'{text}' is not the address of a WebSocket. Use ws://HOST:PORT.");

    private static bool HasScheme(string word, string scheme) => word.StartsWith(scheme, StringComparison.OrdinalIgnoreCase);

    // A computer may have the name of a file. tcp://take.bin means the computer.
    private static bool IsFileName(string word) =>
        word.AsSpan().TrimEnd('/').ContainsAny('/', '\\') || FileKinds.OfName(word) is not null || System.IO.File.Exists(word);
}
