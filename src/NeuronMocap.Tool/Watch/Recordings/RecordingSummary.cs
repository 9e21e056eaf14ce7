using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>What a recording has become, in one line for standard error.</summary>
internal static class RecordingSummary
{
    public static string Describe(StreamRecorder recorder)
    {
        RecordingStatistics statistics = recorder.GetStatistics();
        string path = TerminalText.Clean(recorder.CurrentPath);
        string files = statistics.Files == 1 ? path : Quantity.Format($"{statistics.Files} files, the last one {path}");
        string text = Quantity.Format(
            $"recorded {statistics.Duration.TotalSeconds:0.0} s, {statistics.Bytes:#,0} bytes in {statistics.Pieces:#,0} pieces, to {files}; lost {statistics.LostPieces:#,0} pieces");
        return recorder.Failure is { } failure ? $"{text}; the recording ended early: {FileFault.OfWriting(failure, recorder.CurrentPath)}"
            : recorder.Completion.IsCompleted ? text + "."
            : text + "; the disk does not take the rest.";
    }
}
