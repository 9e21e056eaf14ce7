using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Server;

/// <summary>Settings of a <see cref="Broadcaster"/>: those of Axis Neuron's broadcasting page, and those of a test server.</summary>
/// <remarks>The broadcaster copies the settings when it is created. Later changes have no effect.</remarks>
public sealed partial class BroadcasterOptions
{
    /// <summary>The value of <see cref="FrameRate"/> that sends as fast as each recipient reads.</summary>
    public const double MaxFrameRate = double.PositiveInfinity;

    /// <summary>One source for each avatar, 1 to 256. The avatar indices follow the order of the list.</summary>
    /// <remarks>Sources are called on several threads at once. If their lengths differ, the broadcast ends with the shortest.</remarks>
    public IReadOnlyList<MotionSource> Sources { get; set; } = [];

    /// <summary>A file to send instead of <see cref="Sources"/>: a recording, or a raw dump of a stream's bytes. Default: null.</summary>
    /// <remarks>
    /// Every byte is sent as it was received, including bytes that are not part of a packet. Packets and lines of text are sent whole, each at the
    /// time of its last byte. A raw dump has no times. It is sent at <see cref="FrameRate"/>, or as <see cref="Recording.PlaybackOptions.FrameRate"/>
    /// describes.
    /// <para>
    /// Settings that shape the packets of sources (names, format, layout, frame limit) must keep their defaults. Commands of clients are not
    /// answered.
    /// </para>
    /// </remarks>
    public string? RecordingPath { get; set; }

    /// <summary>A reader whose stream is sent on, instead of <see cref="Sources"/>. Default: null.</summary>
    /// <remarks>
    /// Every packet and every line of text is sent at once and as it was received: header, index, name, and unknown values. Bytes that are neither precede the
    /// next packet. Only a packet that was cut off is left out, and counted in <see cref="BroadcasterStatistics.IncompletePackets"/>. Datagrams that
    /// <see cref="NeuronReaderOptions.AllowedSenders"/> refuses are not sent. Over UDP, each packet becomes one datagram.
    /// <para>
    /// The broadcaster neither starts nor disposes the reader, which can run before, or start later. Clients stay connected while the reader has no
    /// connection. The broadcast is over when the reader has stopped. Several broadcasters can have the same reader.
    /// </para>
    /// <para>
    /// Settings that shape the packets of sources must keep their defaults, as for a recording. The reader must not play a file: set
    /// <see cref="RecordingPath"/>. A <see cref="CommandRelay"/> passes the command channel on.
    /// </para>
    /// </remarks>
    public NeuronReader? Reader { get; set; }

    /// <summary>Speed at which <see cref="RecordingPath"/> is sent, relative to the recorded speed, 0.01 to 100. Default: 1.</summary>
    public double RecordingSpeed { get; set; } = 1;

    /// <summary>Whether <see cref="RecordingPath"/> restarts at its end. Default: false.</summary>
    public bool LoopRecording { get; set; }

    /// <summary>Names of the avatars, in the order of <see cref="Sources"/>. Default: none.</summary>
    /// <remarks>
    /// A name has at most 32 bytes of UTF-8; the rest is cut off. Avatars without a name are called Char00, Char01 and so on.
    /// </remarks>
    public IReadOnlyList<string> AvatarNames { get; set; } = [];

    /// <summary>TCP port to listen on, 0 to 65535. Null does not listen. Default: 7001, as in Axis Neuron.</summary>
    /// <remarks>
    /// 0 takes any free port. Read it from <see cref="Broadcaster.LocalEndPoint"/>. Without a port, the broadcast goes to
    /// <see cref="UdpDestinations"/> and to readers of <see cref="Broadcaster.CreateLocalSource"/>.
    /// </remarks>
    public int? Port { get; set; } = ProtocolConstants.DefaultPort;

    /// <summary>
    /// Port for calculation packets only, 0 to 65535. Null sends them on the same connections, behind the motion packets. Default: null.
    /// </summary>
    /// <remarks>
    /// Servers normally use two ports, 7001 and 7003 (protocol.md section 4.1). The setting needs <see cref="Calculation"/>,
    /// <see cref="StudioCalculation"/>, a <see cref="RecordingPath"/> or a <see cref="Reader"/>. The calculation packets of a recording or a reader then go
    /// to this port, whichever way they were received.
    /// <para>
    /// Over TCP the broadcaster listens on this port and <see cref="BindAddress"/> whenever <see cref="Port"/> is set. 0 takes any free port. Read it
    /// from <see cref="Broadcaster.CalculationEndPoint"/>. Without <see cref="Port"/>, 0 only separates the packets for a server that accepts the clients. Over UDP, calculation packets go to this port of every destination, from a separate
    /// socket.
    /// </para>
    /// <para>A line of text does not name its avatar. With several avatars, only the order of the lines identifies the avatar.</para>
    /// </remarks>
    public int? CalculationPort { get; set; }

    /// <summary>Whether motion packets are sent. Default: true.</summary>
    /// <remarks>
    /// False sends only calculation packets, to <see cref="Port"/> and <see cref="UdpDestinations"/>. It needs
    /// <see cref="Calculation"/> or <see cref="StudioCalculation"/>.
    /// </remarks>
    public bool SendMotion { get; set; } = true;

    /// <summary>Address to listen on, one of this computer's. <see cref="IPAddress.Any"/> listens on all addresses. Default: loopback.</summary>
    /// <remarks>With the default, nothing leaves the computer.</remarks>
    public IPAddress BindAddress { get; set; } = IPAddress.Loopback;

    /// <summary>
    /// Maximum number of simultaneous TCP clients on each port, 1 to 4096. When a port is full, a new client replaces one that has closed its sending side;
    /// without such a client, it is refused and counted. Default: 256.
    /// </summary>
    public int MaxClients { get; set; } = 256;

    /// <summary>
    /// Destinations of datagrams. Every datagram goes to each of them. Broadcast and multicast addresses are allowed. Default: none.
    /// </summary>
    public IReadOnlyList<IPEndPoint> UdpDestinations { get; set; } = [];

    /// <summary>
    /// Frames per second, 0.01 to 100,000, or <see cref="MaxFrameRate"/>. Null uses the rate of the first source. Default: null.
    /// </summary>
    /// <remarks>
    /// <para>
    /// A number paces the broadcast. Each frame is made once, at its time, and sent to all recipients. A client that does not read loses whole
    /// packets and delays no other recipient.
    /// </para>
    /// <para>
    /// <see cref="MaxFrameRate"/> gives every client the whole take from frame 0, as fast as it reads. A client loses nothing (see
    /// <see cref="ClientTimeout"/> for the exception), and its connection is closed after the last frame. UDP has no flow control, so datagrams are
    /// sent as fast as the system takes them.
    /// </para>
    /// <para>A recording has its own times and accepts only <see cref="MaxFrameRate"/> or null. A reader accepts only null.</para>
    /// </remarks>
    public double? FrameRate { get; set; }

    /// <summary>Number of frames to send for each avatar, at least 1. Null sends all frames. Default: null.</summary>
    public long? MaxFrames { get; set; }

    /// <summary>Whether the broadcast waits for the first client, which then gets frame 0 first. Default: false.</summary>
    /// <remarks>
    /// A client is a TCP client, or a reader of <see cref="Broadcaster.CreateLocalSource"/>. With a <see cref="CalculationPort"/>, the broadcast waits
    /// until each of the two ports has had a client.
    /// </remarks>
    public bool WaitForClient { get; set; }

    /// <summary>
    /// Whether every bone carries a position, not only the hips (Axis Neuron's setting Displacement). Null follows the first source. Default: null.
    /// </summary>
    public bool? IncludeDisplacement { get; set; }

    /// <summary>Whether six values of the reference come first (Axis Neuron's setting Reference). Default: false.</summary>
    public bool IncludeReference { get; set; }

    /// <summary>Rotation order of the angles (Axis Neuron's setting Rotation). Default: YXZ.</summary>
    public RotationOrder RotationOrder { get; set; } = RotationOrder.YXZ;

    /// <summary>Format of the stream: packets of Axis Neuron or Axis Studio, or lines of text. Default: packets of Axis Neuron.</summary>
    public BroadcastFormat Format { get; set; }

    /// <summary>Version of the motion packets, 1.0 or 1.1, which determines the layout of their header. Default: null.</summary>
    /// <remarks>
    /// Null uses the version of the format: 1.1.0.0, or 1.1.0.1 in <see cref="BroadcastFormat.Studio"/>, which allows no other version. It must be
    /// null for text, which carries no version. Axis Studio's setting "Use old header format" sends <see cref="DataVersion.Old"/> with
    /// <see cref="BroadcastFormat.Binary"/>.
    /// </remarks>
    public DataVersion? DataVersion { get; set; }

    /// <summary>Computes the values of calculation packets. Null sends no calculation packets. Default: null.</summary>
    /// <remarks>
    /// A calculation packet follows each motion packet on the same connection, or goes to <see cref="CalculationPort"/>.
    /// <see cref="BroadcastFormat.Studio"/> uses <see cref="StudioCalculation"/> instead.
    /// </remarks>
    public CalculationProvider? Calculation { get; set; }

    /// <summary>Number of values in a calculation packet: 946, or 338 for the body without fingers, as before b15. Default: 946.</summary>
    public int CalculationValueCount { get; set; } = CalculationFrame.FullValueCount;

    /// <summary>
    /// Computes the calculation packets of <see cref="BroadcastFormat.Studio"/>. Null sends none. Default: null.
    /// </summary>
    /// <remarks>Use <see cref="StudioCalculationSynthesizer"/>, for example. Other formats use <see cref="Calculation"/> instead.</remarks>
    public StudioCalculationProvider? StudioCalculation { get; set; }

    /// <summary>Decimals of the numbers in text, 0 to 6. The number that real servers send is unknown. Default: 2.</summary>
    public int TextDecimals { get; set; } = TextEncoder.DefaultDecimals;

    /// <summary>
    /// Whether TCP clients get answers to data commands, which they send on the data connection (protocol.md section 7). Default: true.
    /// </summary>
    /// <remarks>
    /// The commands ask for bone sizes, BVH text, the number of avatars, the frequency and the combination mode, and register for changes of them.
    /// Servers newer than b12 do not answer. Requests do not affect other clients: at most 1024 requests of a client wait, and further requests are
    /// dropped and counted.
    /// <para>
    /// With a <see cref="Reader"/>, the commands are passed to its server, on the connection of the reader. The replies are part of its stream, so all
    /// clients receive them. When the reader connects again, the registrations of all clients are repeated. The server gets the end of a registration when no
    /// other client has registered for the same value.
    /// </para>
    /// </remarks>
    public bool AnswerDataCommands { get; set; } = true;

    /// <summary>
    /// Number of frames, each of all avatars, that a client may fall behind at a paced rate before it loses some, 1 to 65,536. Default: 256.
    /// </summary>
    /// <remarks>All clients share the memory. In a recording or the stream of a reader, every packet and line counts as a frame.</remarks>
    public int QueueCapacity { get; set; } = 256;

    /// <summary>
    /// How long a write to a TCP client may wait before the client is disconnected: 1 second to 10 minutes, or infinite. Default: 1 minute.
    /// </summary>
    /// <remarks>
    /// The timeout frees the places of clients that hang or lost power or network. Their connections are reset. Use
    /// <see cref="Timeout.InfiniteTimeSpan"/> for a client that is being debugged.
    /// <para>
    /// The system buffers data and wakes the writer only when much of its buffer is free. A client that steadily takes one megabyte within this time
    /// always stays connected. A slower client may be disconnected. With the default, only clients below 17 kB/s can be affected.
    /// </para>
    /// </remarks>
    public TimeSpan ClientTimeout { get; set; } = TimeSpan.FromMinutes(1);

    /// <summary>
    /// How long clients may take after the last frame to read their queued data and close their side, 0 to 10 minutes. Default: 5 seconds.
    /// </summary>
    public TimeSpan CloseTimeout { get; set; } = TimeSpan.FromSeconds(5);

    // Returns a copy that no other code can change, with every setting in its range.
    internal BroadcasterOptions CopyChecked()
    {
        var copy = (BroadcasterOptions)MemberwiseClone();
        copy.Sources = Sources?.ToArray() ?? [];
        copy.AvatarNames = AvatarNames?.ToArray() ?? [];
        copy.UdpDestinations = UdpDestinations?.Select(static each => each is null ? each! : new IPEndPoint(each.Address, each.Port)).ToArray() ?? [];
        BroadcasterOptionsCheck.Check(copy);
        return copy;
    }
}
