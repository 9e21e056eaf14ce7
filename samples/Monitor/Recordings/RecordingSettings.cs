using NeuronMocap.Recording;

namespace NeuronMocap.Monitor.Recordings;

/// <summary>What to record to.</summary>
/// <param name="Path">The file, as the command line names it.</param>
/// <param name="Options">How.</param>
internal sealed record RecordingSettings(string Path, RecordingOptions Options)
{
    // EEXIST, and what Windows calls ERROR_FILE_EXISTS.
    private const int FileExistsUnix = 17;
    private const int FileExistsWindows = unchecked((int)0x80070050);

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
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            bool isThere = exception.HResult is FileExistsUnix or FileExistsWindows;
            error = $"--record: {exception.Message}{(isThere ? " --overwrite replaces a file that is there." : string.Empty)}";
            return null;
        }
    }
}
