using System.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Export;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>The recordings of a run: that of --record, and those that the key of the live view starts. Not thread-safe.</summary>
/// <param name="reader">The reader to record.</param>
/// <param name="settings">The settings of --record; null without it.</param>
/// <param name="folder">The folder of recordings without a name; empty for the current one.</param>
internal sealed class TakeRecorder(NeuronReader reader, RecordingSettings? settings, string folder = "")
{
    private readonly List<Take> _takes = [];

    /// <summary>The recordings, in the order of their start.</summary>
    public IReadOnlyList<Take> Takes => _takes;

    /// <summary>The running recording; null for none.</summary>
    public Take? Current => _takes is [.., { IsRecording: true } last] ? last : null;

    /// <summary>Completes when the recording of --record has failed. Null without one.</summary>
    public Task? Broken { get; private set; }

    /// <summary>Number of frames of all kinds that have arrived in the run.</summary>
    public long FramesArrived => CountFrames(reader.GetStatistics());

    public static long CountFrames(ReaderStatistics statistics) =>
        statistics.MotionFrames + statistics.CalculationFrames + statistics.StudioCalculationFrames;

    /// <summary>Starts the recording of --record.</summary>
    /// <param name="error">The reason if it cannot start.</param>
    public bool TryBegin(out string? error)
    {
        error = null;
        if (settings is null)
            return true;
        if (settings.TryStart(reader, out error) is not { } recorder)
            return false;

        _takes.Add(new Take(recorder, FramesArrived));
        Broken = ExportRun.WaitForFailureAsync(recorder.Completion, () => recorder.Failure);
        return true;
    }

    /// <summary>Starts another recording, in a new file.</summary>
    /// <param name="now">The time of this computer, for the name of the file.</param>
    /// <returns>Null, or the reason why it cannot start.</returns>
    public FileFailure? Begin(DateTime now)
    {
        var options = new RecordingOptions
        {
            Compress = settings?.Options.Compress ?? false,
            MaxFileSize = settings?.Options.MaxFileSize,
            MaxFileDuration = settings?.Options.MaxFileDuration,
            MaxFiles = settings?.Options.MaxFiles,
        };
        foreach (string path in TakeNames.After(settings?.Path, now, folder))
        {
            try
            {
                _takes.Add(new Take(reader.StartRecording(path, options), FramesArrived));
                return null;
            }
            catch (IOException exception) when (FileFault.IsExisting(exception))
            {
                // The next name may be free.
            }
            catch (ObjectDisposedException)
            {
                return FileFailure.OfRecording(path, "the stream has ended.");
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or ArgumentException)
            {
                return FileFailure.OfRecording(path, FileFault.OfWriting(exception, path));
            }
        }

        throw new UnreachableException();
    }

    /// <summary>Closes the files and reports the result of each recording. The reader has ended before.</summary>
    /// <param name="streams">Receives a line for each recording on standard error.</param>
    /// <returns>Whether all recordings are complete.</returns>
    public async Task<bool> FinishAsync(StandardStreams streams)
    {
        foreach (Take take in _takes)
        {
            await take.Recorder.DisposeAsync();
            await streams.ComplainAsync(RecordingSummary.Describe(take, FramesArrived));
        }

        return _takes.TrueForAll(static take => take.Recorder is { Failure: null, Completion.IsCompleted: true });
    }

    /// <summary>Formats "Recorded 12.3 s, 738 frames, 1.1 MB to take.nmrec."</summary>
    public static string DescribeEnd(Take take, long arrived)
    {
        RecordingStatistics statistics = take.Recorder.GetStatistics();
        return Quantity.Format(
            $"Recorded {Quantity.Duration(statistics.Duration)}, {Quantity.Count(take.CountFrames(arrived), "frame")}, {Quantity.Bytes(statistics.Bytes)} to {TerminalText.Clean(take.Recorder.CurrentPath)}.");
    }
}
