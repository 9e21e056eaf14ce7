using NeuronMocap.Recording;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.View.Actions;

/// <summary>The recording that runs, or has just ended.</summary>
/// <param name="State">"recording" or "idle".</param>
/// <param name="File">The name of the file, without its folder; null for none.</param>
/// <param name="Seconds">Its duration.</param>
/// <param name="Bytes">Its size.</param>
/// <param name="Frames">The number of frames that arrived during it.</param>
internal sealed record RecordingMessage(string State, string? File, double Seconds, long Bytes, long Frames)
{
    public const string Recording = "recording";
    public const string Idle = "idle";

    public static RecordingMessage None { get; } = new(Idle, File: null, 0, 0, 0);

    public string Type { get; } = "recording";

    /// <summary>The id of the take that the finished recording has become; null for none.</summary>
    public string? Take { get; init; }

    /// <summary>Describes a recording, as if it still ran.</summary>
    /// <param name="take">The recording.</param>
    /// <param name="arrived">Frames that have arrived in the whole run.</param>
    public static RecordingMessage Of(Take take, long arrived)
    {
        RecordingStatistics statistics = take.Recorder.GetStatistics();
        string file = Path.GetFileName(take.Recorder.CurrentPath);
        return new RecordingMessage(Recording, file, statistics.Duration.TotalSeconds, statistics.Bytes, take.CountFrames(arrived));
    }
}
