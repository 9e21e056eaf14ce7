using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>Describes a recording at the end of the run, in one line for standard error.</summary>
internal static class RecordingSummary
{
    /// <summary>Describes a recording.</summary>
    /// <param name="take">The recording.</param>
    /// <param name="arrived">Frames that arrived in the whole run.</param>
    public static string Describe(Take take, long arrived)
    {
        StreamRecorder recorder = take.Recorder;
        RecordingStatistics statistics = recorder.GetStatistics();
        string path = TerminalText.Clean(recorder.CurrentPath);
        string files = statistics.Files == 1 ? path : Quantity.Format($"{statistics.Files} files, the last one {path}");

        // If a file could not be written to its end, only the file itself knows the number of its frames.
        string frames = recorder.Failure is null ? $"{Quantity.Count(take.CountFrames(arrived), "frame")}, " : string.Empty;
        string text = Quantity.Format(
            $"recorded {statistics.Duration.TotalSeconds:0.0} s, {frames}{Quantity.Count(statistics.Bytes, "byte")} in {Quantity.Count(statistics.Pieces, "piece")}, to {files}; lost {Quantity.Count(statistics.LostPieces, "piece")}");
        return recorder.Failure is { } failure ? $"{text}; the recording ended early: {FileFault.OfWriting(failure, recorder.CurrentPath)}"
            : recorder.Completion.IsCompleted ? text + "."
            : text + "; the disk does not take the rest.";
    }
}
