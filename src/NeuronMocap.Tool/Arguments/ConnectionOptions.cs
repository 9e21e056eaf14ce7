using System.Net;
using NeuronMocap.RabbitMq;
using NeuronMocap.Server;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Settings of a connection, from the command line.</summary>
internal sealed record ConnectionOptions
{
    private static readonly TimeSpan LongestSilence = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan LongestConnect = TimeSpan.FromSeconds(5);

    /// <summary>The TCP server; null for UDP, a broker and the demo.</summary>
    public ServerAddress? Server { get; init; }

    /// <summary>How the certificate of the TCP server is checked; null for a connection without TLS.</summary>
    public NeuronTlsOptions? Tls { get; init; }

    /// <summary>The address of a server of WebSockets; null for other sources.</summary>
    public Uri? WebSocket { get; init; }

    /// <summary>The UDP port; null for TCP and for the demo.</summary>
    public int? UdpPort { get; init; }

    /// <summary>The port for poses over VMC; null for other sources.</summary>
    public int? VmcPort { get; init; }

    /// <summary>The RabbitMQ broker and what to receive from it; null for all other sources.</summary>
    public RabbitMqSourceOptions? Broker { get; init; }

    /// <summary>Address of this computer to connect from or receive on; null for the system's choice.</summary>
    public IPAddress? LocalAddress { get; init; }

    /// <summary>Addresses that may send over UDP; empty for all.</summary>
    public IReadOnlyList<IPAddress> AllowedSenders { get; init; } = [];

    /// <summary>The rotation order. Null to detect it; the demo then uses YXZ.</summary>
    public RotationOrder? RotationOrder { get; init; }

    /// <summary>Port of the command channel, for information that the stream lacks; null for none.</summary>
    public int? CommandPort { get; init; }

    /// <summary>Port of additional calculation data; null for none.</summary>
    public int? CalculationPort { get; init; }

    /// <summary>Whether the reader stops when the connection ends or cannot be made.</summary>
    public bool Once { get; init; }

    /// <summary>Time after which the run ends; null for no limit. It bounds the time-outs of the reader.</summary>
    public TimeSpan? Duration { get; init; }

    /// <summary>Whether a simulator inside this process is the server.</summary>
    public bool IsDemo => Server is null && UdpPort is null && VmcPort is null && WebSocket is null && Broker is null;

    /// <summary>The source, as an argument of the command line.</summary>
    public string Source => this switch
    {
        { UdpPort: { } port } => Arguments.Source.OfUdp(port, LocalAddress).ToString(),
        { VmcPort: { } port } => Arguments.Source.OfVmc(port, LocalAddress).ToString(),
        { WebSocket: { } address } => Arguments.Source.OfWebSocket(address).ToString(),
        { Broker: { } broker } => Arguments.Source.OfBroker(broker).ToString(),
        { Server: { } server } => Arguments.Source.OfServer(server, Tls is not null).ToString(),
        _ => Arguments.Source.Demo.ToString(),
    };

    /// <summary>
    /// Finds values that are valid separately but not together, and describes the fault in words of this program. Null if there is none.
    /// </summary>
    public string? FindFault()
    {
        try
        {
            using var reader = new NeuronReader(ToReaderOptions(Server));
            return null;
        }
        catch (ArgumentException fault)
        {
            return OptionNames.Translate(fault);
        }
    }

    /// <summary>Creates the options of the reader.</summary>
    /// <param name="server">The TCP server to connect to: <see cref="Server"/>, or the demo's.</param>
    public NeuronReaderOptions ToReaderOptions(ServerAddress? server)
    {
        var options = new NeuronReaderOptions
        {
            RotationOrder = RotationOrder,
            CommandPort = CommandPort,
            CalculationPort = CalculationPort,
            LocalAddress = LocalAddress,
            Tls = Tls,
            Source = WebSocket is null ? null : new WebSocketSource(WebSocket) { ConnectTimeout = WithinHalfOfDuration(LongestConnect) },
            SilenceTimeout = WithinHalfOfDuration(LongestSilence),
            ConnectTimeout = WithinHalfOfDuration(LongestConnect),
            Reconnect = { Enabled = !Once },
        };
        if (UdpPort is { } port)
        {
            options.Transport = TransportKind.Udp;
            options.Port = port;
            options.AllowedSenders = AllowedSenders;
        }

        if (VmcPort is { } poses)
        {
            options.Source = new VmcSource(poses, LocalAddress);
            options.LocalAddress = null;
        }

        if (Broker is { } broker)
        {
            broker.ConnectTimeout = options.ConnectTimeout;
            options.Source = new RabbitMqSource(broker);
        }

        // Over UDP, the server is the computer on which a diagnosis looks for the stream if nothing arrives.
        if (server is { } address)
        {
            options.Host = address.Host;
            if (UdpPort is null)
                options.Port = address.Port;
        }

        return options;
    }

    // In a short run, the normal time-out of the reader would come too late to describe the problem.
    private TimeSpan WithinHalfOfDuration(TimeSpan longest) =>
        TimeSpan.FromSeconds(Math.Clamp(Duration?.TotalSeconds / 2 ?? double.MaxValue, 0.1, longest.TotalSeconds));
}
