namespace NeuronMocap.Recording;

/// <summary>Represents one entry of a recording. It refers to the reader's memory and is valid until the next entry is read.</summary>
public readonly ref struct RecordingEntry
{
    /// <summary>The kind of the entry, which determines the members that have a value.</summary>
    public RecordingEntryKind Kind { get; init; }

    /// <summary>
    /// The time since <see cref="RecordingReader.StartTime"/>, in steps of 100 ns. It never decreases, unless the reader was moved.
    /// </summary>
    public TimeSpan Time { get; init; }

    /// <summary>
    /// Number of the connection. Not valid for <see cref="RecordingEntryKind.Metadata"/> and <see cref="RecordingEntryKind.Damaged"/>.
    /// </summary>
    public int Connection { get; init; }

    /// <summary>Over UDP, the number of the sender within its connection; otherwise 0.</summary>
    public int Sender { get; init; }

    /// <summary>The received bytes (<see cref="RecordingEntryKind.Bytes"/>). A datagram may be empty.</summary>
    public ReadOnlySpan<byte> Bytes { get; init; }

    /// <summary>The connection that was opened (<see cref="RecordingEntryKind.ConnectionOpened"/>).</summary>
    public RecordedConnection? Opened { get; init; }

    /// <summary>
    /// The address of the sender (<see cref="RecordingEntryKind.SenderAdded"/>), the reason why the connection was closed
    /// (<see cref="RecordingEntryKind.ConnectionClosed"/>), or the value (<see cref="RecordingEntryKind.Metadata"/>).
    /// </summary>
    public string? Text { get; init; }

    /// <summary>The key of the value (<see cref="RecordingEntryKind.Metadata"/>).</summary>
    public string? Key { get; init; }

    /// <summary>Number of lost pieces (<see cref="RecordingEntryKind.BytesLost"/>).</summary>
    public long LostPieces { get; init; }

    /// <summary>
    /// Number of lost bytes: of the stream (<see cref="RecordingEntryKind.BytesLost"/>), or of the file (<see cref="RecordingEntryKind.Damaged"/>).
    /// </summary>
    public long LostBytes { get; init; }
}
