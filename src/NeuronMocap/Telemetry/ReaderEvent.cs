namespace NeuronMocap;

/// <summary>What an event is about. The numbers are stable; on .NET they are the event ids of the log.</summary>
public enum ReaderEventId
{
    /// <summary>The reader looks for the server.</summary>
    Connecting = 1,

    /// <summary>The connection stands, or the UDP port is bound; no frame has arrived yet.</summary>
    Connected = 2,

    /// <summary>Frames arrive.</summary>
    Receiving = 3,

    /// <summary>The connection stands, but no frames arrive.</summary>
    Silent = 4,

    /// <summary>The connection failed or ended; another attempt follows.</summary>
    Waiting = 5,

    /// <summary>The reader ended for good.</summary>
    Stopped = 6,

    /// <summary>Frames did not arrive that the server had sent.</summary>
    FramesLost = 10,

    /// <summary>A queue was full.</summary>
    FramesDropped = 11,

    /// <summary>Bytes arrived that belong to no packet.</summary>
    BytesSkipped = 12,

    /// <summary>A handler of the application threw.</summary>
    CallbackFailed = 13,

    /// <summary>A recording began.</summary>
    RecordingStarted = 20,

    /// <summary>A recording has ended, as it was told to.</summary>
    RecordingStopped = 21,

    /// <summary>A recording was not written fast enough and lacks what arrived meanwhile.</summary>
    RecordingIncomplete = 22,

    /// <summary>A recording ended because it could not be written any more: the disk is full, for example.</summary>
    RecordingFailed = 23,

    /// <summary>An old file of a recording could not be deleted; the recording goes on and tries again.</summary>
    RecordingFileKept = 24,

    /// <summary>A BVH export began.</summary>
    ExportStarted = 30,

    /// <summary>A BVH export has ended, as it was told to.</summary>
    ExportStopped = 31,

    /// <summary>A BVH export was not written fast enough and lacks frames that arrived meanwhile.</summary>
    ExportIncomplete = 32,

    /// <summary>A BVH export ended because it could not be written any more: the disk is full, for example.</summary>
    ExportFailed = 33,
}

/// <summary>How much an event matters; as the levels of the same names in Microsoft.Extensions.Logging.</summary>
public enum ReaderEventLevel
{
    /// <summary>For whoever looks for a fault: attempts to connect, and the same problem once more.</summary>
    Debug,

    /// <summary>The ordinary course.</summary>
    Information,

    /// <summary>Something is missing or was lost; the reader goes on.</summary>
    Warning,

    /// <summary>The reader ended because its connection failed or was cut off, or a handler threw.</summary>
    Error,
}

/// <summary>Something that deserves a line in a log: a change of the connection's state, or what was lost since the last such line.</summary>
/// <param name="Id">What it is about.</param>
/// <param name="Level">How much it matters.</param>
/// <param name="Reader">Name of the reader: <see cref="NeuronReaderOptions.Name"/>.</param>
/// <param name="Message">One or two English sentences for people.</param>
public readonly record struct ReaderEvent(ReaderEventId Id, ReaderEventLevel Level, string Reader, string Message)
{
    /// <summary>The new state of the connection, for a change of it.</summary>
    public ConnectionStatus? Status { get; init; }

    /// <summary>How many frames, bytes, pieces or exceptions came since the last event of this kind; 0 for a change of the state.</summary>
    public long Count { get; init; }

    /// <summary>How many came since the reader was made; 0 for a change of the state.</summary>
    public long Total { get; init; }

    /// <summary>
    /// The queue that dropped frames (<see cref="FrameQueue.Name"/>), the <see cref="Protocol.SkipReason"/> of bytes, or the file of a recording or an
    /// export; otherwise null.
    /// </summary>
    public string? Subject { get; init; }

    /// <summary>The newest exception of a handler, or what ended a recording or an export; otherwise null.</summary>
    public Exception? Exception { get; init; }

    /// <summary>Level, reader and message.</summary>
    /// <returns>A line for a log.</returns>
    public override string ToString() => $"{Level}: {Reader}: {Message}";
}
