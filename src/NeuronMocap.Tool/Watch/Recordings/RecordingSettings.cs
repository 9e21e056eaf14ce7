using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Recordings;

/// <summary>Settings of a recording.</summary>
/// <param name="Path">The file, as the command line names it.</param>
/// <param name="Options">The options of the recording.</param>
internal sealed record RecordingSettings(string Path, RecordingOptions Options)
{
    /// <summary>The argument that names the file, for errors.</summary>
    public string Argument { get; init; } = "--record";

    /// <summary>Starts the recording.</summary>
    /// <param name="reader">The reader to record.</param>
    /// <param name="error">The reason if the recording cannot start.</param>
    /// <returns>The recording; null if it cannot start.</returns>
    public StreamRecorder? TryStart(NeuronReader reader, out string? error)
    {
        try
        {
            error = null;
            return reader.StartRecording(Path, Options);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or ArgumentException)
        {
            error = $"{Argument}: {Describe(exception)}";
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
