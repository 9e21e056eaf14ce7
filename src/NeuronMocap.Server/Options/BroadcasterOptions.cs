using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Server;

/// <summary>
/// What a <see cref="Broadcaster"/> sends, how, and to whom: the settings of Axis Neuron's broadcasting page and those of a test server.
/// The broadcaster copies them when it is made; changes after that have no effect.
/// </summary>
public sealed partial class BroadcasterOptions
{
    /// <summary>The <see cref="FrameRate"/> that means: as fast as each receiver takes it.</summary>
    public const double MaxFrameRate = double.PositiveInfinity;

    /// <summary>
    /// One performance for each avatar, 1 to 256 of them; avatar indices follow the order. They are called on several threads at once.
    /// With sources of different lengths the broadcast ends with the shortest.
    /// </summary>
    public IReadOnlyList<MotionSource> Sources { get; set; } = [];

    /// <summary>
    /// A file to send instead of <see cref="Sources"/>: a recording, or a raw dump of a stream's bytes. Every byte is sent as it was received, also what is no
    /// packet, in whole packets or lines of text, each when its last byte came. What makes packets of sources (names, format, layout, frame limit) has to be
    /// left alone, and commands of clients are not answered. A raw dump, which has no times, is sent at <see cref="FrameRate"/>, or as
    /// <see cref="Recording.PlaybackOptions.FrameRate"/> has it. Default: null.
    /// </summary>
    public string? RecordingPath { get; set; }

    /// <summary>How many times as fast as it was recorded <see cref="RecordingPath"/> is sent, 0.01 to 100. Default: 1.</summary>
    public double RecordingSpeed { get; set; } = 1;

    /// <summary>Whether <see cref="RecordingPath"/> starts again at its end. Default: false.</summary>
    public bool LoopRecording { get; set; }

    /// <summary>
    /// Names of the avatars, the first for the first source; at most 32 bytes of UTF-8 each, the rest is cut off. Avatars without one are
    /// Char00, Char01 and so on. Default: none.
    /// </summary>
    public IReadOnlyList<string> AvatarNames { get; set; } = [];

    /// <summary>
    /// TCP port to listen on, 0 to 65535; 0 takes any free one, which <see cref="Broadcaster.LocalEndPoint"/> tells; null does not listen.
    /// Default: 7001, as in Axis Neuron.
    /// </summary>
    public int? Port { get; set; } = ProtocolConstants.DefaultPort;

    /// <summary>
    /// Port for calculation packets alone, 0 to 65535; null sends them behind the motion packets, on the same connections. Servers normally have a port for each,
    /// 7001 and 7003 (protocol.md section 4.1). Over TCP the broadcaster listens there, on <see cref="BindAddress"/>, wherever <see cref="Port"/> is set;
    /// 0 takes any free one, which <see cref="Broadcaster.CalculationEndPoint"/> tells. Over UDP, calculation goes to this port of every destination, from a
    /// socket of its own. Needs <see cref="Calculation"/>, <see cref="StudioCalculation"/> or a <see cref="RecordingPath"/>, whose calculation packets then go there,
    /// whichever way they were received. A line of text does not say whose calculation it is: with
    /// several avatars only the order tells. Default: null.
    /// </summary>
    public int? CalculationPort { get; set; }

    /// <summary>
    /// Whether motion packets are sent. False sends calculation packets alone, to <see cref="Port"/> and <see cref="UdpDestinations"/>, and needs
    /// <see cref="Calculation"/> or <see cref="StudioCalculation"/>. Default: true.
    /// </summary>
    public bool SendMotion { get; set; } = true;

    /// <summary>
    /// Address to listen on, one of this machine. Default: loopback, so that nothing leaves the machine unless told to;
    /// <see cref="IPAddress.Any"/> listens on all.
    /// </summary>
    public IPAddress BindAddress { get; set; } = IPAddress.Loopback;

    /// <summary>Largest number of TCP clients at a time on each port, 1 to 4096; more are refused and counted. Default: 256.</summary>
    public int MaxClients { get; set; } = 256;

    /// <summary>
    /// Where to send datagrams, each to every destination; broadcast and multicast addresses are allowed. Default: none.
    /// </summary>
    public IReadOnlyList<IPEndPoint> UdpDestinations { get; set; } = [];

    /// <summary>
    /// Frames per second, 0.01 to 100,000, or <see cref="MaxFrameRate"/>; null takes the first source's own. Default: null.
    /// <para>
    /// At a number, each frame is made once, at its time, and sent to all; a client that does not read loses whole packets and delays
    /// nobody. At <see cref="MaxFrameRate"/> every client gets the whole take from frame 0 as fast as it reads, loses nothing (but see
    /// <see cref="ClientTimeout"/>), and its connection is closed after the last frame; UDP, which cannot push back, is sent as fast as the
    /// system takes it. A recording has its own times: <see cref="MaxFrameRate"/> or null.
    /// </para>
    /// </summary>
    public double? FrameRate { get; set; }

    /// <summary>Frames of each avatar to send, at least 1; null sends all there are. Default: null.</summary>
    public long? MaxFrames { get; set; }

    /// <summary>
    /// Whether nothing is sent before the first TCP client is there, which then gets frame 0 first. With a <see cref="CalculationPort"/>: before each of the
    /// two ports has had one. Needs <see cref="Port"/>. Default: false.
    /// </summary>
    public bool WaitForClient { get; set; }

    /// <summary>
    /// Axis Neuron's setting Displacement: whether every bone carries a position, not only the hips; null as the first source has it.
    /// Default: null.
    /// </summary>
    public bool? IncludeDisplacement { get; set; }

    /// <summary>Axis Neuron's setting Reference: whether six values of the Reference node come first. Default: false.</summary>
    public bool IncludeReference { get; set; }

    /// <summary>Axis Neuron's setting Rotation: the order of the rotation values. Default: YXZ.</summary>
    public RotationOrder RotationOrder { get; set; } = RotationOrder.YXZ;

    /// <summary>What is sent: packets of Axis Neuron or Axis Studio, or lines of text. Default: Axis Neuron's packets.</summary>
    public BroadcastFormat Format { get; set; }

    /// <summary>
    /// Version of the motion packets, 1.0 or 1.1, which decides the layout of their header: <see cref="DataVersion.Old"/> is what
    /// Axis Studio's "Use old header format" sends, with the format <see cref="BroadcastFormat.Binary"/>. Null: what the format has, 1.1.0.0, or
    /// 1.1.0.1 in <see cref="BroadcastFormat.Studio"/>, where it cannot be another; must be null for text, which carries none. Default: null.
    /// </summary>
    public DataVersion? DataVersion { get; set; }

    /// <summary>
    /// Computes calculation packets, which then follow each motion packet on the same connections, or go to <see cref="CalculationPort"/>; null sends
    /// none. Not for <see cref="BroadcastFormat.Studio"/>, which has packets of its own: <see cref="StudioCalculation"/>. Default: null.
    /// </summary>
    public CalculationProvider? Calculation { get; set; }

    /// <summary>Values of a calculation packet: 946, or 338 for the body without fingers, as before b15. Default: 946.</summary>
    public int CalculationValueCount { get; set; } = CalculationFrame.FullValueCount;

    /// <summary>
    /// Computes the calculation packets of <see cref="BroadcastFormat.Studio"/>, as <see cref="StudioCalculationSynthesizer"/> does; null sends
    /// none. For no other format. Default: null.
    /// </summary>
    public StudioCalculationProvider? StudioCalculation { get; set; }

    /// <summary>Digits after the point in text, 0 to 6. How many real servers send is not known. Default: 2.</summary>
    public int TextDecimals { get; set; } = TextEncoder.DefaultDecimals;

    /// <summary>
    /// Whether TCP clients get answers to the commands of the old generation, which they send on the data connection (protocol.md section 7):
    /// bone sizes, BVH text, number of avatars, frequency and combination mode, and the registration for changes of them. A server newer than b12
    /// does not answer. Requests cost others nothing: of each client 1024 wait at most, more are dropped and counted. Default: true.
    /// </summary>
    public bool AnswerDataCommands { get; set; } = true;

    /// <summary>
    /// How many frames of all avatars a client may fall behind at a paced rate before it loses some, 1 to 65,536. Default: 256. The
    /// memory is shared by all clients.
    /// </summary>
    public int QueueCapacity { get; set; } = 256;

    /// <summary>
    /// How long a write to a TCP client may wait before the client is let go, and its connection reset: its computer lost power or
    /// network, or it hangs, and keeps others from its place. The system buffers, and wakes the writer only when much of its buffer is
    /// free: a client that takes a megabyte within this time, at any even pace, always stays; a slower one may be let go.
    /// 1 second to 10 minutes, or <see cref="Timeout.InfiniteTimeSpan"/> to wait for
    /// ever, as for a client that is being debugged. Default: 1 minute, which only a client below 17 kB/s can miss.
    /// </summary>
    public TimeSpan ClientTimeout { get; set; } = TimeSpan.FromMinutes(1);

    /// <summary>
    /// How long clients may take, after the last frame, to read what is queued for them and to close their side, 0 to 10 minutes.
    /// Default: 5 seconds.
    /// </summary>
    public TimeSpan CloseTimeout { get; set; } = TimeSpan.FromSeconds(5);

    // A copy that nobody else can change, with every setting in its range.
    internal BroadcasterOptions CopyChecked()
    {
        var copy = (BroadcasterOptions)MemberwiseClone();
        copy.Sources = Sources?.ToArray() ?? [];
        copy.AvatarNames = AvatarNames?.ToArray() ?? [];
        copy.UdpDestinations = UdpDestinations?.ToArray() ?? [];
        BroadcasterOptionsCheck.Check(copy);
        return copy;
    }
}
