using System.Net;
using NeuronMocap.Commands;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>Options of a <see cref="NeuronReader"/>. The reader copies them when it is made; later changes have no effect on it.</summary>
public sealed partial class NeuronReaderOptions
{
    // Of a copy: the name of its source, which is code of the application.
    private string? _sourceName;

    /// <summary>
    /// Name of the reader in metrics and logs, which distinguishes several readers. Null, the default, for the server's address or the UDP port.
    /// If two readers have the same name, the second one gets a number.
    /// </summary>
    public string? Name { get; set; }

    /// <summary>
    /// Opens the streams of bytes to receive in place of a connection; null, the default, for TCP or UDP. The copied options refer to the same source.
    /// </summary>
    /// <remarks>
    /// With a source, these options have no effect: <see cref="Transport"/>, <see cref="Port"/>, <see cref="SharePort"/>, <see cref="AllowedSenders"/>,
    /// <see cref="Tls"/> and <see cref="CalculationPort"/>. <see cref="Host"/>, <see cref="LocalAddress"/> and <see cref="ConnectTimeout"/> apply to the command channel only,
    /// and have no effect without a <see cref="CommandPort"/>. The reader sends nothing to a source, so <see cref="NeuronReader.DataCommands"/> are not
    /// available.
    /// </remarks>
    public ByteSource? Source { get; set; }

    /// <summary>TCP or UDP; must match the setting of the server. The default is TCP.</summary>
    public TransportKind Transport { get; set; } = TransportKind.Tcp;

    /// <summary>
    /// Name or address of the computer that runs Axis Neuron. The default is this computer. If a name has several addresses, the reader tries them one
    /// after another. Over UDP, only the command channel uses it.
    /// </summary>
    public string Host { get; set; } = "127.0.0.1";

    /// <summary>
    /// TCP port of the server, 1 to 65535, or UDP port to receive on, 0 to 65535; UDP port 0 takes any free port. The default is 7001.
    /// </summary>
    public int Port { get; set; } = ProtocolConstants.DefaultPort;

    /// <summary>
    /// Encrypts the TCP connection, and that of <see cref="CalculationPort"/>, with TLS, and checks the server's certificate. Null, the default, for a connection
    /// without TLS, as Axis Neuron and Axis Studio need it. The connection of <see cref="CommandPort"/> is never encrypted. A connection with TLS always has a
    /// thread of its own, whatever <see cref="ReceiveThread"/> says.
    /// </summary>
    public NeuronTlsOptions? Tls { get; set; }

    /// <summary>
    /// Address of this computer to connect from or receive on. With null, the default, the system chooses for TCP, and UDP receives on all IPv4 addresses.
    /// Set it if the computer has several networks.
    /// </summary>
    /// <remarks>With a local address, Linux and macOS deliver no UDP broadcasts. Leave it null if the server sends to a broadcast address.</remarks>
    public IPAddress? LocalAddress { get; set; }

    /// <summary>
    /// Allows other programs to bind the same UDP port. All of them then get broadcast and multicast datagrams; other datagrams reach only the one program
    /// that the system chooses. The default is off: a port in use is then an error with a clear reason.
    /// </summary>
    public bool SharePort { get; set; }

    /// <summary>
    /// Addresses of the computers that may send over UDP. If it is empty, the default, all may send. The reader counts datagrams of other computers, and
    /// drops them unread. Set it if you share the network with others: any computer on it can send to the port. Not used for TCP, where <see cref="Host"/>
    /// determines the sender.
    /// </summary>
    public IReadOnlyList<IPAddress> AllowedSenders { get; set; } = [];

    /// <summary>
    /// Longest time to wait for the name to resolve, and for each of its addresses to answer: more than zero, at most 5 minutes. The default is 5 s.
    /// </summary>
    public TimeSpan ConnectTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>Time without a frame after which the state becomes Silent: 0.1 s to an hour. The default is 3 s.</summary>
    public TimeSpan SilenceTimeout { get; set; } = TimeSpan.FromSeconds(3);

    /// <summary>
    /// The thread that receives and therefore runs the handlers of frames. The default is <see cref="ReceiveThread.Auto"/>.
    /// <see cref="ConnectionStatus.ReceiveThread"/> tells which one a connection uses. Set <see cref="ReceiveThread.Dedicated"/> if the program blocks
    /// pool threads.
    /// </summary>
    public ReceiveThread ReceiveThread { get; set; }

    /// <summary>Whether and when to reconnect after a connection fails or ends.</summary>
    public ReconnectPolicy Reconnect { get; set; } = new();

    /// <summary>
    /// Order of the rotation values, which is a setting of the server. If it is null, the default, the reader detects it. Each frame of Axis Studio
    /// contains it, and the command channel reports it; otherwise it is YXZ, the default of Axis Neuron.
    /// </summary>
    /// <remarks>
    /// A value applies to all frames. If a stream contains another order, the reader reports it once per connection, with
    /// <see cref="ConnectionReason.RotationOrderMismatch"/>.
    /// </remarks>
    public RotationOrder? RotationOrder { get; set; }

    /// <summary>
    /// Names of the spine and neck bones on the server. If it is null, the default, the reader takes them from the BVH header that the command channel
    /// returns. Without a header it uses those of the manual's Appendix A.
    /// </summary>
    public SkeletonVariant? SkeletonVariant { get; set; }

    /// <summary>
    /// TCP port of the command channel on <see cref="Host"/>, 1 to 65535, also if frames arrive over UDP. Null, the default, for no command channel. See
    /// <see cref="ProtocolConstants.DefaultCommandPort"/>.
    /// </summary>
    /// <remarks>
    /// On this port the reader asks for the rotation order, the skeleton variant and the bodies of <see cref="NeuronReader.TryGetBody"/>. It asks on every
    /// new connection. Without an answer it asks again after 5, 10 and 20 s, and then every 40 s. Frames do not wait for the answer. Until it arrives,
    /// they are interpreted as without this option.
    /// </remarks>
    public int? CommandPort { get; set; }

    /// <summary>
    /// Port on which the server broadcasts calculation data, if it differs from <see cref="Port"/>: 1 to 65535; for UDP also 0 for any free port. Null,
    /// the default, for none. The usual port is <see cref="ProtocolConstants.DefaultCalculationPort"/>.
    /// </summary>
    /// <remarks>
    /// <para>
    /// With this option the reader has a second connection to <see cref="Host"/> over TCP, or a second port over UDP. Each one reconnects independently.
    /// Consumers get the frames of both alike; frames of one server have the same <see cref="AvatarFrame.Sender"/>. If both ports have the same value, one
    /// connection serves both.
    /// </para>
    /// <para>
    /// If the second connection fails, motion continues, and the status reports <see cref="ConnectionReason.CalculationUnavailable"/>. Motion that arrives
    /// on the second connection is skipped and counted.
    /// </para>
    /// </remarks>
    public int? CalculationPort { get; set; }

    /// <summary>
    /// Largest number of values that a packet may announce, 1 to 1,000,000. Larger packets are skipped and counted. The default is 10,224, the most that
    /// the vendor's library delivers.
    /// </summary>
    public int MaxValues { get; set; } = ProtocolConstants.DefaultMaxValues;

    // How long a stop waits for a handler that is still busy. Tests set a longer time, because a busy machine can delay any thread.
    internal TimeSpan StopTimeout { get; set; } = TimeSpan.FromSeconds(2);

    internal string DisplayName => Name ?? Target;

    // The name of what the reader receives from.
    internal string Target => _sourceName ?? (Transport == TransportKind.Udp ? $"UDP port {Port}" : Link.Target);

    internal FrameFormat Format => new(RotationOrder, SkeletonVariant);

    internal LinkOptions Link => new(Host, Port)
    {
        LocalAddress = LocalAddress,
        ConnectTimeout = ConnectTimeout,
        MaxValues = MaxValues,
        SharePort = SharePort,
        ReceiveThread = ReceiveThread,
        Tls = Tls,
        CloseTimeout = StopTimeout / 4,
    };

    // Null if motion and calculation data share one connection, or if calculation data is not received.
    internal LinkOptions? CalculationLink => CalculationPort is { } port && (port != Port || port == 0) ? Link with { Port = port } : null;

    internal NeuronCommandOptions? Commands => CommandPort is { } port
        ? new NeuronCommandOptions
        {
            Host = Host,
            Port = port,
            ConnectTimeout = ConnectTimeout,

            // Over UDP, the local address belongs to the sender's network, which may not be the way to the host.
            LocalAddress = Transport == TransportKind.Tcp ? LocalAddress : null,
        }
        : null;

    // Throws what the source throws instead of its name.
    internal NeuronReaderOptions Copy()
    {
        var copy = (NeuronReaderOptions)MemberwiseClone();
        copy.Reconnect = Reconnect?.Copy()!;
        copy.Tls = Tls?.Copy();
        copy.AllowedSenders = AllowedSenders?.ToArray() ?? [];
        if (Source is not null)
        {
            copy._sourceName = Source.Name ?? string.Empty;
            copy.ForgetNetwork();
        }

        return copy;
    }

    internal NeuronReaderOptions CopyFor(ByteSource? source)
    {
        var copy = (NeuronReaderOptions)MemberwiseClone();
        copy.Source = source;
        return copy;
    }

    // For a playback, which connects to nothing and asks nothing.
    internal NeuronReaderOptions CopyFor(RecordingPlayer player)
    {
        NeuronReaderOptions copy = CopyFor(source: null).Copy();
        copy.Name ??= player.Target;
        copy.CommandPort = null;
        copy.ForgetNetwork();
        copy.Reconnect = new ReconnectPolicy();
        return copy;
    }

    // For a source of bytes, and for a playback: what has no effect must not be wrong either. The rest is that of the command channel.
    private void ForgetNetwork()
    {
        var unused = new NeuronReaderOptions();
        if (CommandPort is null)
            (Host, ConnectTimeout) = (unused.Host, unused.ConnectTimeout);
        if (CommandPort is null || Transport != TransportKind.Tcp)
            LocalAddress = null;

        (Transport, Port, Tls, CalculationPort) = (TransportKind.Tcp, unused.Port, null, null);
        (SharePort, AllowedSenders) = (false, []);
    }

    // For a copy.
    internal string? FindFault()
    {
        if (Source is not null && string.IsNullOrWhiteSpace(_sourceName))
            return "The Name of Source is empty; give it a name for messages, or leave out the override.";

        if (!Enum.IsDefined(typeof(TransportKind), Transport))
            return $"Transport is {Transport}; it must be Tcp or Udp.";

        if (!Enum.IsDefined(typeof(ReceiveThread), ReceiveThread))
            return $"ReceiveThread is {ReceiveThread}; it must be Auto, Dedicated or Pool.";

        if (Name is not null && string.IsNullOrWhiteSpace(Name))
            return "Name is empty; set a name, or leave it null.";

        int lowestPort = Transport == TransportKind.Udp ? 0 : 1;
        if (string.IsNullOrWhiteSpace(Host))
            return "Host is empty; give the name or address of the computer that runs Axis Neuron.";
        if (AddressText.HasPort(Host))
            return $"Host is {Host}; it must be a name or address alone. Set Port, or make the options with NeuronReaderOptions.Parse.";
        if (Port < lowestPort || Port > IPEndPoint.MaxPort)
            return $"Port is {Port}; it must be {lowestPort} to {IPEndPoint.MaxPort}.";
        if (ConnectTimeout <= TimeSpan.Zero || ConnectTimeout > TimeSpan.FromMinutes(5))
            return $"ConnectTimeout is {ConnectTimeout}; it must be more than zero and at most 5 minutes.";
        if (SilenceTimeout < TimeSpan.FromSeconds(0.1) || SilenceTimeout > TimeSpan.FromHours(1))
            return $"SilenceTimeout is {SilenceTimeout}; it must be 0.1 s to 1 hour.";
        if (RotationOrder is { } order && !Enum.IsDefined(typeof(RotationOrder), order))
            return $"RotationOrder is {order}; it must be one of the six orders, or null.";
        if (SkeletonVariant is { } variant && !Enum.IsDefined(typeof(SkeletonVariant), variant))
            return $"SkeletonVariant is {variant}; it must be Neck1, Spine3 or null.";
        if (Tls is not null && Transport == TransportKind.Udp)
            return "Tls is set and Transport is Udp; TLS needs TCP.";
        if (CommandPort is < 1 or > IPEndPoint.MaxPort)
            return $"CommandPort is {CommandPort}; it must be 1 to {IPEndPoint.MaxPort}, or null.";
        if (CommandPort == Port && Transport == TransportKind.Tcp && Source is null)
            return $"CommandPort and Port are both {Port}; frames and the command channel need different ports, by default 7001 and 8013.";
        if (CalculationPort < lowestPort || CalculationPort > IPEndPoint.MaxPort)
            return $"CalculationPort is {CalculationPort}; it must be {lowestPort} to {IPEndPoint.MaxPort}, or null.";
        if (CalculationPort is not null && CalculationPort == CommandPort && Transport == TransportKind.Tcp)
            return $"CalculationPort and CommandPort are both {CommandPort}; calculation data and the command channel need different ports, by default 7003 and 8013.";
        if (MaxValues is < 1 or > ProtocolConstants.LargestMaxValues)
            return $"MaxValues is {MaxValues}; it must be 1 to 1,000,000.";
        if (AllowedSenders?.Contains(null!) == true)
            return "AllowedSenders contains null; it must contain addresses only.";
        if (Reconnect is null)
            return "Reconnect is null; to turn reconnecting off, set its Enabled to false.";

        return Tls?.FindFault() ?? Reconnect.FindFault();
    }
}
