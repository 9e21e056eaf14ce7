namespace NeuronMocap.Recording;

/// <summary>What an entry of a recording tells. Numbers below 128 are those of the file.</summary>
public enum RecordingEntryKind
{
    /// <summary>A piece of bytes arrived: what one read of the socket brought over TCP, a datagram over UDP.</summary>
    Bytes = 0,

    /// <summary>A connection stands, or a UDP port is bound.</summary>
    ConnectionOpened = 1,

    /// <summary>Over UDP: datagrams of an address follow that had none before, or had been forgotten.</summary>
    SenderAdded = 2,

    /// <summary>Over UDP: a sender was forgotten to make room for others; should it send again, it is a new one.</summary>
    SenderRemoved = 3,

    /// <summary>A connection is gone.</summary>
    ConnectionClosed = 4,

    /// <summary>Bytes arrived that the recording does not hold, because it could not be written fast enough.</summary>
    BytesLost = 5,

    /// <summary>Something about the recording as a whole that was not known before.</summary>
    Metadata = 6,

    /// <summary>Part of the file cannot be read; what it held is missing here. Only a reader tells this, no file holds it.</summary>
    Damaged = 255,
}
