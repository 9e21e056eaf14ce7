namespace NeuronMocap.Recording;

/// <summary>Specifies the kind of an entry of a recording. Values below 128 are those of the file format.</summary>
public enum RecordingEntryKind
{
    /// <summary>A piece of bytes arrived: over TCP, the result of one read from the socket; over UDP, a datagram.</summary>
    Bytes = 0,

    /// <summary>A connection was established, or a UDP port was bound.</summary>
    ConnectionOpened = 1,

    /// <summary>Over UDP: a new sender. Its address was unknown or forgotten; its datagrams follow.</summary>
    SenderAdded = 2,

    /// <summary>Over UDP: a sender was forgotten to make room for others. If it sends again, it counts as a new sender.</summary>
    SenderRemoved = 3,

    /// <summary>A connection was closed.</summary>
    ConnectionClosed = 4,

    /// <summary>Bytes arrived that are missing from the recording, because it could not be written fast enough.</summary>
    BytesLost = 5,

    /// <summary>Metadata of the whole recording that was not known before.</summary>
    Metadata = 6,

    /// <summary>
    /// Part of the file cannot be read, and its content is missing here. Only a reader creates this entry; files do not contain it.
    /// </summary>
    Damaged = 255,
}
