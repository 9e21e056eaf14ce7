using System.Net;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Play;
using NeuronMocap.Tool.Watch.Export;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Watch;

/// <summary>How the frames are shown.</summary>
internal enum OutputKind
{
    /// <summary>The live view on a terminal, else one plain line a second.</summary>
    Person,

    /// <summary>Every frame and every change of the state, one JSON object a line.</summary>
    Json,

    /// <summary>One JSON object at the end.</summary>
    Quiet,
}

/// <summary>What the command line asks for.</summary>
internal sealed record WatchOptions
{
    private static readonly TimeSpan LongestSilence = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan LongestConnect = TimeSpan.FromSeconds(5);

    /// <summary>The TCP server; null for UDP and for the demo.</summary>
    public ServerAddress? Server { get; init; }

    /// <summary>The UDP port; null for TCP and for the demo.</summary>
    public int? UdpPort { get; init; }

    /// <summary>Address of this computer to connect from or receive on; null for the system's choice.</summary>
    public IPAddress? LocalAddress { get; init; }

    /// <summary>Addresses that may send over UDP; empty for all.</summary>
    public IReadOnlyList<IPAddress> AllowedSenders { get; init; } = [];

    /// <summary>Whether a simulator inside this process is the server.</summary>
    public bool IsDemo => Server is null && UdpPort is null && Play is null;

    /// <summary>What is received from, as a word of the command line.</summary>
    public string Source => this switch
    {
        { Play: { } play } => play.File,
        { UdpPort: { } port } => Arguments.Source.OfUdp(port, LocalAddress).ToString(),
        { Server: { } server } => Arguments.Source.OfServer(server).ToString(),
        _ => Arguments.Source.Demo.ToString(),
    };

    /// <summary>Null to find it out; the demo then has YXZ.</summary>
    public RotationOrder? RotationOrder { get; init; }

    /// <summary>Where to ask for what the stream does not say; null for nowhere.</summary>
    public int? CommandPort { get; init; }

    /// <summary>Where calculation data come from besides; null for nowhere.</summary>
    public int? CalculationPort { get; init; }

    /// <summary>The file to show; null for a server's stream.</summary>
    public PlaySettings? Play { get; init; }

    public bool Once { get; init; }

    /// <summary>The BVH file to write meanwhile; null for none.</summary>
    public ExportSettings? Export { get; init; }

    /// <summary>What to record to; null to record nothing.</summary>
    public RecordingSettings? Recording { get; init; }

    /// <summary>Number of frames, motion and calculation together, to end after; null for no end.</summary>
    public long? Frames { get; init; }

    /// <summary>Time to end after; null for no end, and for a diagnosis in its own time.</summary>
    public TimeSpan? Duration { get; init; }

    public OutputKind Output { get; init; }

    /// <summary>What is wrong with values that are each right by themselves, in words of this program; null when nothing is.</summary>
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

    /// <summary>Options of the reader.</summary>
    /// <param name="server">The TCP server to connect to: <see cref="Server"/>, or the demo's.</param>
    public NeuronReaderOptions ToReaderOptions(ServerAddress? server)
    {
        var options = new NeuronReaderOptions
        {
            RotationOrder = RotationOrder,
            CommandPort = CommandPort,
            CalculationPort = CalculationPort,
            LocalAddress = IsDemo ? null : LocalAddress,
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

        // Over UDP a server is the computer at which a diagnosis looks for the stream when nothing arrives.
        if (server is { } address)
        {
            options.Host = address.Host;
            if (UdpPort is null)
                options.Port = address.Port;
        }

        return options;
    }

    // A run that is shorter than the reader's patience would end before the reader says what is wrong.
    private TimeSpan WithinHalfOfDuration(TimeSpan longest) =>
        TimeSpan.FromSeconds(Math.Clamp(Duration?.TotalSeconds / 2 ?? double.MaxValue, 0.1, longest.TotalSeconds));
}
