namespace NeuronMocap.Recording;

/// <summary>One entry of a recording. It lies in the reader's memory and is valid until the reader is asked for the next.</summary>
public readonly ref struct RecordingEntry
{
    /// <summary>What it tells; which other members have a value depends on it.</summary>
    public RecordingEntryKind Kind { get; init; }

    /// <summary>When it happened, since <see cref="RecordingReader.StartTime"/>, in steps of 100 ns. Never before the entry that precedes it, unless the reader was moved.</summary>
    public TimeSpan Time { get; init; }

    /// <summary>Number of the connection; not of <see cref="RecordingEntryKind.Metadata"/> and <see cref="RecordingEntryKind.Damaged"/>.</summary>
    public int Connection { get; init; }

    /// <summary>Over UDP, number of the sender within its connection; otherwise 0.</summary>
    public int Sender { get; init; }

    /// <summary>What arrived (<see cref="RecordingEntryKind.Bytes"/>); a datagram may be empty.</summary>
    public ReadOnlySpan<byte> Bytes { get; init; }

    /// <summary>What was opened (<see cref="RecordingEntryKind.ConnectionOpened"/>).</summary>
    public RecordedConnection? Opened { get; init; }

    /// <summary>
    /// The sender's address (<see cref="RecordingEntryKind.SenderAdded"/>), why the connection is gone
    /// (<see cref="RecordingEntryKind.ConnectionClosed"/>), or the value (<see cref="RecordingEntryKind.Metadata"/>).
    /// </summary>
    public string? Text { get; init; }

    /// <summary>What the value is (<see cref="RecordingEntryKind.Metadata"/>).</summary>
    public string? Key { get; init; }

    /// <summary>Pieces that are missing (<see cref="RecordingEntryKind.BytesLost"/>).</summary>
    public long LostPieces { get; init; }

    /// <summary>
    /// Bytes that are missing: of the stream (<see cref="RecordingEntryKind.BytesLost"/>), or of the file
    /// (<see cref="RecordingEntryKind.Damaged"/>).
    /// </summary>
    public long LostBytes { get; init; }
}
