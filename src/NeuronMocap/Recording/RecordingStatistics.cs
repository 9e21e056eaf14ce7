namespace NeuronMocap.Recording;

/// <summary>What a recording has done so far, at the moment of asking. Each figure is exact; together they may be an instant apart.</summary>
public readonly record struct RecordingStatistics
{
    /// <summary>Pieces of bytes that were taken: reads of the socket over TCP, datagrams over UDP.</summary>
    public long Pieces { get; init; }

    /// <summary>Bytes in them.</summary>
    public long Bytes { get; init; }

    /// <summary>Pieces that arrived and are missing, because the queue was full.</summary>
    public long LostPieces { get; init; }

    /// <summary>Bytes in those.</summary>
    public long LostBytes { get; init; }

    /// <summary>Files that were begun.</summary>
    public int Files { get; init; }

    /// <summary>Bytes that were written to all files, those since deleted included.</summary>
    public long WrittenBytes { get; init; }

    /// <summary>How long the recording has run, or ran.</summary>
    public TimeSpan Duration { get; init; }
}
