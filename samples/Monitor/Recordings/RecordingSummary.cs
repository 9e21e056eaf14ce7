using NeuronMocap.Monitor.Terminal;
using NeuronMocap.Recording;

namespace NeuronMocap.Monitor.Recordings;

/// <summary>What a recording has become, in one line for standard error.</summary>
internal static class RecordingSummary
{
    public static string Describe(StreamRecorder recorder)
    {
        RecordingStatistics statistics = recorder.GetStatistics();
        string files = statistics.Files == 1 ? recorder.CurrentPath : Quantity.Format($"{statistics.Files} files, the last one {recorder.CurrentPath}");
        string text = Quantity.Format(
            $"recorded {statistics.Duration.TotalSeconds:0.0} s, {statistics.Bytes:#,0} bytes in {statistics.Pieces:#,0} pieces, to {files}; lost {statistics.LostPieces:#,0} pieces");
        return recorder.Failure is { } failure ? $"{text}; the recording ended before its time: {failure.Message}"
            : recorder.Completion.IsCompleted ? text + "."
            : text + "; the disk does not take the rest.";
    }
}
