namespace NeuronMocap.Recording;

/// <summary>A snapshot of the progress of a recording. Each number is exact; together, they may be from slightly different moments.</summary>
public readonly record struct RecordingStatistics
{
    /// <summary>
    /// Number of pieces in the files: reads from the socket over TCP, datagrams over UDP. Pieces received within the last
    /// <see cref="RecordingOptions.FlushInterval"/> may not be counted yet.
    /// </summary>
    public long Pieces { get; init; }

    /// <summary>Number of bytes in these pieces.</summary>
    public long Bytes { get; init; }

    /// <summary>Number of received pieces that are missing, because the queue was full or the recording failed before they were written.</summary>
    public long LostPieces { get; init; }

    /// <summary>Number of bytes in the missing pieces.</summary>
    public long LostBytes { get; init; }

    /// <summary>Number of files that were created.</summary>
    public int Files { get; init; }

    /// <summary>Number of bytes of all files that the operating system has accepted, including files that were deleted since.</summary>
    public long WrittenBytes { get; init; }

    /// <summary>
    /// Number of old files beyond <see cref="RecordingOptions.MaxFiles"/> that could not be deleted. Each new file triggers another attempt.
    /// </summary>
    public int UndeletedFiles { get; init; }

    /// <summary>How long the recording has run, or ran. After a failure, the time that the files cover.</summary>
    public TimeSpan Duration { get; init; }
}
