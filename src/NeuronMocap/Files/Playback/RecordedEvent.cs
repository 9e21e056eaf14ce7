using System.Net;

namespace NeuronMocap.Recording;

internal enum RecordedEventKind
{
    // A connection was established, or a UDP port was bound.
    Opened,

    // A piece of the connection's bytes, as received; over UDP, a datagram.
    Bytes,

    // Received bytes are missing here.
    Lost,

    // The connection ended.
    Closed,

    // The end of the file.
    End,
}

// One event of the recorded stream, with its time since the start. Bytes and sender are valid until the next event is read.
internal readonly record struct RecordedEvent(RecordedEventKind Kind, TimeSpan Time)
{
    public TransportKind Transport { get; init; }

    // Number of the connection.
    public int Connection { get; init; }

    // Whether this is the additional connection of a calculation port.
    public bool IsCalculation { get; init; }

    // For an opened connection: whether it was already open. Its first bytes may then be the middle of a packet.
    public bool WasOpen { get; init; }

    // For lost bytes: whether a part of the file is damaged or missing, so that bytes of every connection can be missing.
    public bool IsDamage { get; init; }

    public ArraySegment<byte> Bytes { get; init; }

    // Over UDP only.
    public SocketAddress? Sender { get; init; }

    // For a closed connection: the reason in words; may be empty.
    public string? Reason { get; init; }
}
