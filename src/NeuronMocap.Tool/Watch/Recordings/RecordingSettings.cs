using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>What to record to.</summary>
/// <param name="Path">The file, as the command line names it.</param>
/// <param name="Options">How.</param>
internal sealed record RecordingSettings(string Path, RecordingOptions Options)
{
    /// <summary>Begins the recording.</summary>
    /// <param name="reader">What to record.</param>
    /// <param name="error">Why it cannot begin.</param>
    /// <returns>The recording; null when it cannot begin.</returns>
    public StreamRecorder? TryStart(NeuronReader reader, out string? error)
    {
        try
        {
            error = null;
            return reader.StartRecording(Path, Options);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or ArgumentException)
        {
            error = $"--record: {Describe(exception)}";
            return null;
        }
    }

    private string Describe(Exception exception)
    {
        if (!FileFault.IsExisting(exception) || InputFile.FindOddKind(Path) is not null)
            return FileFault.OfWriting(exception, Path);

        return Options.MaxFileSize is null && Options.MaxFileDuration is null
            ? $"{FileFault.OfWriting(exception, Path)} --overwrite replaces it."
            : $"files with numbers of '{TerminalText.Clean(Path)}' already exist. --overwrite replaces them.";
    }
}
