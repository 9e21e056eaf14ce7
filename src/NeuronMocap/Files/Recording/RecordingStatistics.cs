namespace NeuronMocap.Recording;

/// <summary>What a recording has done so far, at the moment of asking. Each figure is exact; together they may be an instant apart.</summary>
public readonly record struct RecordingStatistics
{
    /// <summary>
    /// Pieces of bytes that the files hold: reads of the socket over TCP, datagrams over UDP. What arrived within the last
    /// <see cref="RecordingOptions.FlushInterval"/> may not be counted yet.
    /// </summary>
    public long Pieces { get; init; }

    /// <summary>Bytes in them.</summary>
    public long Bytes { get; init; }

    /// <summary>Pieces that arrived and are missing: the queue was full, or the recording failed before they were written.</summary>
    public long LostPieces { get; init; }

    /// <summary>Bytes in those.</summary>
    public long LostBytes { get; init; }

    /// <summary>Files that were begun.</summary>
    public int Files { get; init; }

    /// <summary>Bytes that the system has taken of all files, those since deleted included.</summary>
    public long WrittenBytes { get; init; }

    /// <summary>Old files that <see cref="RecordingOptions.MaxFiles"/> wants deleted and that could not be; each new file tries again.</summary>
    public int UndeletedFiles { get; init; }

    /// <summary>How long the recording has run, or ran. Of one that failed, the time of what the files hold.</summary>
    public TimeSpan Duration { get; init; }
}
