using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap;

/// <content>Recording of the received bytes.</content>
public sealed partial class NeuronReader
{
    // Gets the received bytes before they are parsed.
    internal StreamTap Tap => _recordings.Tap;

    // Whether the reader plays a file. Its tap then gets nothing.
    internal bool IsPlayback => _player is not null;

    // The most values that a packet of this reader may have.
    internal int MaxValues => _options.MaxValues;

    // Sends bytes to the server, if a TCP connection is open. Waits up to a second if the server does not read.
    internal bool TrySend(ReadOnlySpan<byte> bytes) => _supervisor.TrySend(bytes);

    /// <summary>
    /// Records every byte that this reader receives from now on, with the time of its arrival. The file plays back as the live stream did;
    /// docs/reference/recording.md describes its format.
    /// </summary>
    /// <remarks>
    /// <para>You can start a recording before or after the reader starts. A recording includes reconnects. A reader can have several recordings.</para>
    /// <para>
    /// A recording does not contain data that arrived before it was started, nor datagrams that <see cref="NeuronReaderOptions.AllowedSenders"/> refuses.
    /// </para>
    /// <para>A recording ends when it is disposed, when its file can no longer be written, or when the reader ends.</para>
    /// </remarks>
    /// <param name="path">The file, usually with the extension ".nmrec". With a limit of size or time, a number is inserted before the extension.</param>
    /// <param name="options">How to record; copied. Null for the defaults.</param>
    /// <returns>The recording. You can discard it; it then ends with the reader.</returns>
    /// <exception cref="ArgumentException">The path is empty, or an option is out of range; the message names it.</exception>
    /// <exception cref="IOException">
    /// The file exists and <see cref="RecordingOptions.Overwrite"/> is off, or the file is already being written, or it cannot be created.
    /// </exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to create the file.</exception>
    /// <exception cref="InvalidOperationException">The reader plays a file.</exception>
    /// <exception cref="ObjectDisposedException">The reader was disposed, or has stopped.</exception>
    public StreamRecorder StartRecording(string path, RecordingOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(path);
        RecordingOptions how = options?.Copy() ?? new RecordingOptions();
        if (path.Length == 0)
            throw new ArgumentException("The path must not be empty.", nameof(path));
        if (how.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));

        if (IsPlayback)
            throw new InvalidOperationException("The reader plays a file, and a playback cannot be recorded.");

        return _recordings.Start(path, how, this);
    }
}
