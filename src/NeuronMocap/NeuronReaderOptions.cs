using System.Net;
using NeuronMocap.Commands;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>
/// What a <see cref="NeuronReader"/> has to know. The reader takes a copy when it is made; later changes have no effect on it.
/// </summary>
public sealed partial class NeuronReaderOptions
{
    /// <summary>
    /// What metrics and logs call the reader, so that several can be told apart; null, the default, for the server's address or the UDP port.
    /// Where two readers have one name, the second gets a number.
    /// </summary>
    public string? Name { get; set; }

    /// <summary>TCP or UDP, as the server is set. TCP unless set.</summary>
    public TransportKind Transport { get; set; } = TransportKind.Tcp;

    /// <summary>
    /// Name or address of the computer that runs Axis Neuron; this computer unless set. A name with several addresses is tried
    /// address by address. Not used for UDP.
    /// </summary>
    public string Host { get; set; } = "127.0.0.1";

    /// <summary>TCP port of the server, or UDP port to receive on: 1 to 65535, for UDP also 0 for any free one. 7001 unless set.</summary>
    public int Port { get; set; } = ProtocolConstants.DefaultPort;

    /// <summary>
    /// Address of this computer to connect from or receive on; null, the default, lets the system choose for TCP and receives on all IPv4
    /// addresses for UDP. Set it where the computer has several networks.
    /// </summary>
    public IPAddress? LocalAddress { get; set; }

    /// <summary>
    /// Lets other programs bind the same UDP port. Datagrams that are broadcast or multicast then reach all of them, others only the one that
    /// the system chooses. Off unless set: then a port in use is an error with a clear reason.
    /// </summary>
    public bool SharePort { get; set; }

    /// <summary>
    /// Addresses of the computers that may send over UDP; empty, the default, lets everyone. Datagrams of others are dropped before anything
    /// looks into them, and counted. Set it where the network is not yours alone: anyone on it can send to the port. Not used for TCP, where
    /// <see cref="Host"/> says whom the data comes from.
    /// </summary>
    public IReadOnlyList<IPAddress> AllowedSenders { get; set; } = [];

    /// <summary>Longest time to wait for the name, and for each of its addresses to answer. 5 s unless set; more than zero, at most 5 minutes.</summary>
    public TimeSpan ConnectTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>After how long without a frame the state becomes Silent. 3 s unless set; at least 0.1 s, at most an hour.</summary>
    public TimeSpan SilenceTimeout { get; set; } = TimeSpan.FromSeconds(3);

    /// <summary>
    /// On which thread to receive, and so to run the handlers of frames. <see cref="ReceiveThread.Auto"/> unless set.
    /// <see cref="ConnectionStatus.ReceiveThread"/> says which one a connection has. Set it to <see cref="ReceiveThread.Dedicated"/> where
    /// the program blocks the threads of the pool.
    /// </summary>
    public ReceiveThread ReceiveThread { get; set; }

    /// <summary>Whether and when to try again after a connection failed or ended.</summary>
    public ReconnectPolicy Reconnect { get; set; } = new();

    /// <summary>
    /// Order of the rotation values, a setting of the server. Null, the default, to take it from where it can be found: each frame of Axis Studio
    /// says it, and the command channel answers it; where neither does it is YXZ, Axis Neuron's default. A value holds for all frames; a stream that says
    /// otherwise is reported once per connection, with <see cref="ConnectionReason.RotationOrderMismatch"/>.
    /// </summary>
    public RotationOrder? RotationOrder { get; set; }

    /// <summary>
    /// Naming of spine and neck on the server. Null, the default, to take it from the BVH header that the command channel answers; where there is
    /// none it is that of the manual's Appendix A.
    /// </summary>
    public SkeletonVariant? SkeletonVariant { get; set; }

    /// <summary>
    /// TCP port of the command channel on <see cref="Host"/>, 1 to 65535, also where frames come over UDP; null, the default, for none. With one, the
    /// reader asks there for the rotation order and the skeleton variant, on every new connection, and every 5 s until it is answered. Frames do not
    /// wait for the answer: those that come before it are understood as without this option. See <see cref="ProtocolConstants.DefaultCommandPort"/>.
    /// </summary>
    public int? CommandPort { get; set; }

    /// <summary>
    /// Port on which the server broadcasts calculation data, where that is not <see cref="Port"/>: 1 to 65535, for UDP also 0 for any free one. Null, the
    /// default, for none; <see cref="ProtocolConstants.DefaultCalculationPort"/> is usual. Over TCP the reader then has a second connection to
    /// <see cref="Host"/>, over UDP a second port; each reconnects by itself. Frames of both are handed out alike, with the same
    /// <see cref="AvatarFrame.Source"/> for a server. Where the second one fails, motion goes on, and the status says so:
    /// <see cref="ConnectionReason.CalculationUnavailable"/>. Motion that arrives there is skipped and counted. The same value as
    /// <see cref="Port"/> means one connection for both.
    /// </summary>
    public int? CalculationPort { get; set; }

    /// <summary>
    /// Largest number of values that a packet may announce, 1 to 1,000,000; larger ones are skipped and counted. 10,224 unless set, the most
    /// that the vendor's library delivers.
    /// </summary>
    public int MaxValues { get; set; } = ProtocolConstants.DefaultMaxValues;

    internal string DisplayName => Name ?? (Transport == TransportKind.Udp ? $"UDP port {Port}" : Link.Target);

    internal FrameFormat Format => new(RotationOrder, SkeletonVariant);

    internal LinkOptions Link => new(Host, Port)
    {
        LocalAddress = LocalAddress,
        ConnectTimeout = ConnectTimeout,
        MaxValues = MaxValues,
        SharePort = SharePort,
        ReceiveThread = ReceiveThread,
    };

    // Null where motion and calculation data come together, or one of them not at all.
    internal LinkOptions? CalculationLink => CalculationPort is { } port && (port != Port || port == 0) ? Link with { Port = port } : null;

    internal NeuronCommandOptions? Commands => CommandPort is { } port
        ? new NeuronCommandOptions { Host = Host, Port = port, ConnectTimeout = ConnectTimeout }
        : null;

    internal NeuronReaderOptions Copy()
    {
        var copy = (NeuronReaderOptions)MemberwiseClone();
        copy.Reconnect = Reconnect.Copy();
        copy.AllowedSenders = AllowedSenders?.ToArray() ?? [];
        return copy;
    }

    // For a playback: nothing is connected to or asked, and the next connection stands when it did in the recording.
    internal NeuronReaderOptions CopyFor(RecordingPlayer player)
    {
        NeuronReaderOptions copy = Copy();
        copy.Name ??= player.Target;
        copy.Transport = TransportKind.Tcp;
        copy.CommandPort = null;
        copy.CalculationPort = null;
        copy.AllowedSenders = [];
        copy.Reconnect = new ReconnectPolicy { InitialDelay = TimeSpan.Zero, MaxDelay = TimeSpan.Zero };
        return copy;
    }

    internal string? FindFault()
    {
        if (!Enum.IsDefined(typeof(TransportKind), Transport))
            return $"Transport is {Transport}; it must be Tcp or Udp.";

        if (!Enum.IsDefined(typeof(ReceiveThread), ReceiveThread))
            return $"ReceiveThread is {ReceiveThread}; it must be Auto, Dedicated or Pool.";

        if (Name is not null && string.IsNullOrWhiteSpace(Name))
            return "Name is empty; give the reader one, or leave it out.";

        int lowestPort = Transport == TransportKind.Udp ? 0 : 1;
        if (string.IsNullOrWhiteSpace(Host))
            return "Host is empty; give the name or address of the computer that runs Axis Neuron.";
        if (Port < lowestPort || Port > IPEndPoint.MaxPort)
            return $"Port is {Port}; it must be {lowestPort} to {IPEndPoint.MaxPort}.";
        if (ConnectTimeout <= TimeSpan.Zero || ConnectTimeout > TimeSpan.FromMinutes(5))
            return $"ConnectTimeout is {ConnectTimeout}; it must be more than zero and at most 5 minutes.";
        if (SilenceTimeout < TimeSpan.FromSeconds(0.1) || SilenceTimeout > TimeSpan.FromHours(1))
            return $"SilenceTimeout is {SilenceTimeout}; it must be 0.1 s to an hour.";
        if (RotationOrder is { } order && !Enum.IsDefined(typeof(RotationOrder), order))
            return $"RotationOrder is {order}; it must be one of the six orders, or null.";
        if (SkeletonVariant is { } variant && !Enum.IsDefined(typeof(SkeletonVariant), variant))
            return $"SkeletonVariant is {variant}; it must be Neck1, Spine3 or null.";
        if (CommandPort is < 1 or > IPEndPoint.MaxPort)
            return $"CommandPort is {CommandPort}; it must be 1 to {IPEndPoint.MaxPort}, or null.";
        if (CommandPort == Port && Transport == TransportKind.Tcp)
            return $"CommandPort and Port are both {Port}; frames and the command channel have a port each, by default 7001 and 8013.";
        if (CalculationPort < lowestPort || CalculationPort > IPEndPoint.MaxPort)
            return $"CalculationPort is {CalculationPort}; it must be {lowestPort} to {IPEndPoint.MaxPort}, or null.";
        if (CalculationPort is not null && CalculationPort == CommandPort && Transport == TransportKind.Tcp)
            return $"CalculationPort and CommandPort are both {CommandPort}; calculation data and the command channel have a port each, by default 7003 and 8013.";
        if (MaxValues is < 1 or > 1_000_000)
            return $"MaxValues is {MaxValues}; it must be 1 to 1,000,000.";
        if (AllowedSenders?.Contains(null!) == true)
            return "AllowedSenders holds a null; it must hold addresses only.";
        if (Reconnect is null)
            return "Reconnect is null; set its Enabled to false to switch reconnecting off.";

        return Reconnect.FindFault();
    }
}
