using NeuronMocap.Recording;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.View.Actions;

/// <summary>The recording that runs, or has just ended.</summary>
/// <param name="State">"recording" or "idle".</param>
/// <param name="File">The name of the file, without its folder; null for none.</param>
/// <param name="Seconds">Its duration.</param>
/// <param name="Bytes">Its size.</param>
internal sealed record RecordingMessage(string State, string? File, double Seconds, long Bytes)
{
    public const string Recording = "recording";
    public const string Idle = "idle";

    public static RecordingMessage None { get; } = new(Idle, File: null, 0, 0);

    public string Type { get; } = "recording";

    /// <summary>The id of the take that the finished recording has become; null for none.</summary>
    public string? Take { get; init; }

    public static RecordingMessage Of(Take take)
    {
        RecordingStatistics statistics = take.Recorder.GetStatistics();
        return new RecordingMessage(Recording, Path.GetFileName(take.Recorder.CurrentPath), statistics.Duration.TotalSeconds, statistics.Bytes);
    }
}
