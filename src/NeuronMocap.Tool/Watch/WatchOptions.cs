using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Watch.Export;
using NeuronMocap.Tool.Watch.Playback;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Watch;

/// <summary>Settings of a run, from the command line.</summary>
internal sealed record WatchOptions
{
    /// <summary>The connection. For a file, only its rotation order and its duration have a meaning.</summary>
    public ConnectionOptions Connection { get; init; } = new();

    /// <summary>The file to play; null for a server's stream.</summary>
    public PlaySettings? Play { get; init; }

    /// <summary>Whether a simulator inside this process is the server.</summary>
    public bool IsDemo => Play is null && Connection.IsDemo;

    /// <summary>The source, as an argument of the command line.</summary>
    public string Source => Play?.File ?? Connection.Source;

    /// <summary>The BVH file to write at the same time; null for none.</summary>
    public ExportSettings? Export { get; init; }

    /// <summary>The recording to write; null for none.</summary>
    public RecordingSettings? Recording { get; init; }

    /// <summary>Number of motion and calculation frames after which the run ends; null for no limit.</summary>
    public long? Frames { get; init; }

    public OutputKind Output { get; init; }
}
