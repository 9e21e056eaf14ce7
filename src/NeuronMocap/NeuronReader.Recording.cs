using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap;

/// <content>Keeping what arrives.</content>
public sealed partial class NeuronReader
{
    // What arrives, before anything is made of it.
    internal StreamTap Tap => _recordings.Tap;

    /// <summary>
    /// Records every byte that this reader receives from now on, with the time of its arrival, to a file that plays again as the live stream did;
    /// docs/reference/recording.md describes it. The reader may run already or be started later, and reconnects are recorded, too. Where a connection stands
    /// already, what it brought before is not in the recording; datagrams of senders that <see cref="NeuronReaderOptions.AllowedSenders"/> does not
    /// let in never are. The recording ends when it is disposed of, when it cannot be written any more, or with the reader. A reader may have several.
    /// </summary>
    /// <param name="path">The file, usually with the extension ".nmrec". With a limit of size or time, a number goes before the extension.</param>
    /// <param name="options">How to record; copied. Null for the defaults.</param>
    /// <returns>The recording. It is no error to let go of it: it then ends with the reader.</returns>
    /// <exception cref="ArgumentException">The path is empty, or an option out of its range; the message names it.</exception>
    /// <exception cref="IOException">The file exists, and <see cref="RecordingOptions.Overwrite"/> is off, or it cannot be made, or is being written already.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be made.</exception>
    /// <exception cref="InvalidOperationException">The reader plays a file.</exception>
    /// <exception cref="ObjectDisposedException">The reader was disposed of, or has stopped.</exception>
    public StreamRecorder StartRecording(string path, RecordingOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(path);
        RecordingOptions how = options?.Copy() ?? new RecordingOptions();
        if (path.Length == 0)
            throw new ArgumentException("The path is empty.", nameof(path));
        if (how.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        if (_isPlayback)
            throw new InvalidOperationException("What is played is a file already, and is not recorded again.");

        return _recordings.Start(path, how, this);
    }
}
