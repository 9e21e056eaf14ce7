using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch.Playback;

/// <summary>Settings for the playback of a file.</summary>
/// <param name="File">A recording, or bytes without times.</param>
/// <param name="Speed">Speed relative to the recording.</param>
/// <param name="FrameRate">Frames per second of bytes without times; null for the rate that the file states.</param>
/// <param name="Loop">Whether the playback restarts at the end of the file.</param>
internal sealed record PlaySettings(string File, double Speed, double? FrameRate, bool Loop)
{
    /// <summary>Opens the file.</summary>
    /// <param name="order">The rotation order of the command line, or null.</param>
    /// <exception cref="PlayException">The file cannot be played.</exception>
    public RecordingPlayer Open(RotationOrder? order)
    {
        try
        {
            InputFile.Require(File);
            RecordingPlayer player = RecordingPlayer.Open(File, new PlaybackOptions { FrameRate = FrameRate, RotationOrder = order });
            player.Speed = Speed;
            player.Passes = Loop ? RecordingPlayer.Endless : 1;
            return player;
        }
        catch (ArgumentException) when (FrameRate is not null)
        {
            throw new PlayException($"--rate: {TerminalText.Clean(File)} has its own times; --speed changes its speed.");
        }
        catch (Exception exception) when (exception is NeuronException or IOException or UnauthorizedAccessException or ArgumentException)
        {
            string hint = IsOtherTake(exception) ? $" {ToolCommand.Name} convert turns it into one." : string.Empty;
            throw new PlayException(FileFault.OfReading(exception, File) + hint);
        }
    }

    // The library only names the kind of the file.
    private bool IsOtherTake(Exception exception)
    {
        try
        {
            return exception is NeuronException && FileKinds.Recognize(File) is FileKind.Bvh or FileKind.Calculation;
        }
        catch (Exception fault) when (fault is NeuronException or IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }
}

/// <summary>The exception for a file that cannot be played. The message says why.</summary>
internal sealed class PlayException(string message) : Exception(message);
