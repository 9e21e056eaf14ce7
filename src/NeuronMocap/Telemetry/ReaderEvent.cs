namespace NeuronMocap;

/// <summary>The subject of an event. The numbers are stable; on .NET they are the event ids of the log.</summary>
public enum ReaderEventId
{
    /// <summary>The reader tries to connect to the server.</summary>
    Connecting = 1,

    /// <summary>The connection is established, or the UDP port is bound; no frame has arrived yet.</summary>
    Connected = 2,

    /// <summary>Frames arrive.</summary>
    Receiving = 3,

    /// <summary>The connection is established, but no frames arrive.</summary>
    Silent = 4,

    /// <summary>The connection failed or ended; another attempt follows.</summary>
    Waiting = 5,

    /// <summary>The reader ended for good.</summary>
    Stopped = 6,

    /// <summary>Frames that the server sent did not arrive.</summary>
    FramesLost = 10,

    /// <summary>A queue was full and dropped frames.</summary>
    FramesDropped = 11,

    /// <summary>Bytes arrived outside packets.</summary>
    BytesSkipped = 12,

    /// <summary>A handler of the application threw an exception.</summary>
    CallbackFailed = 13,

    /// <summary>A recording has started.</summary>
    RecordingStarted = 20,

    /// <summary>A recording has ended as requested.</summary>
    RecordingStopped = 21,

    /// <summary>A recording was not written fast enough and lacks data that arrived in the meantime.</summary>
    RecordingIncomplete = 22,

    /// <summary>A recording ended because its file can no longer be written, for example because the disk is full.</summary>
    RecordingFailed = 23,

    /// <summary>An old file of a recording could not be deleted; the recording continues and tries again.</summary>
    RecordingFileKept = 24,

    /// <summary>A BVH export has started.</summary>
    ExportStarted = 30,

    /// <summary>A BVH export has ended as requested.</summary>
    ExportStopped = 31,

    /// <summary>A BVH export was not written fast enough and lacks frames that arrived in the meantime.</summary>
    ExportIncomplete = 32,

    /// <summary>A BVH export ended because its file can no longer be written, for example because the disk is full.</summary>
    ExportFailed = 33,
}

/// <summary>The severity of an event; the same as the levels of these names in Microsoft.Extensions.Logging.</summary>
public enum ReaderEventLevel
{
    /// <summary>Helps to find a fault: attempts to connect, and repetitions of a problem.</summary>
    Debug,

    /// <summary>A normal event.</summary>
    Information,

    /// <summary>Data is missing or was lost; the reader continues.</summary>
    Warning,

    /// <summary>The reader ended because its connection failed or was closed, or a handler threw an exception.</summary>
    Error,
}

/// <summary>An event that deserves a line in a log: a change of the connection's state, or the losses since the last such line.</summary>
/// <param name="Id">The subject of the event.</param>
/// <param name="Level">The severity of the event.</param>
/// <param name="Reader">Name of the reader: <see cref="NeuronReaderOptions.Name"/>.</param>
/// <param name="Message">One or two English sentences for people.</param>
public readonly record struct ReaderEvent(ReaderEventId Id, ReaderEventLevel Level, string Reader, string Message)
{
    /// <summary>The new state of the connection, if the event is a change of state; otherwise null.</summary>
    public ConnectionStatus? Status { get; init; }

    /// <summary>Number of frames, bytes, pieces or exceptions since the last event of this kind; 0 for a change of state.</summary>
    public long Count { get; init; }

    /// <summary>The same number since the reader was made; 0 for a change of state.</summary>
    public long Total { get; init; }

    /// <summary>
    /// The queue that dropped frames (<see cref="FrameQueue.Name"/>), the <see cref="Protocol.SkipReason"/> of bytes, or the file of a recording or an
    /// export; otherwise null.
    /// </summary>
    public string? Subject { get; init; }

    /// <summary>The newest exception of a handler, or the one that ended a recording or an export; otherwise null.</summary>
    public Exception? Exception { get; init; }

    /// <summary>Gets the level, the reader and the message.</summary>
    /// <returns>A line for a log.</returns>
    public override string ToString() => $"{Level}: {Reader}: {Message}";
}
