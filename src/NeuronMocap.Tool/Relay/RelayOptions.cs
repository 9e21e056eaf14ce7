using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Watch.Playback;

namespace NeuronMocap.Tool.Relay;

/// <summary>Settings of a relay, from the command line.</summary>
/// <param name="Source">The source.</param>
/// <param name="Connection">The connection to the source. For a file, only its duration has a meaning.</param>
/// <param name="Destinations">Where packets go.</param>
internal sealed record RelayOptions(Source Source, ConnectionOptions Connection, IReadOnlyList<Destination> Destinations)
{
    /// <summary>The file to play; null for a server's stream.</summary>
    public PlaySettings? Play { get; init; }

    /// <summary>Where to listen for clients of the command channel; null for none.</summary>
    public TcpDestination? Commands { get; init; }

    /// <summary>The format of standard output.</summary>
    public OutputKind Output { get; init; }

    /// <summary>Whether existing files are replaced.</summary>
    public bool Overwrite { get; init; }
}
