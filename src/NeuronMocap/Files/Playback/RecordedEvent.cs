using System.Net;

namespace NeuronMocap.Recording;

internal enum RecordedEventKind
{
    // A connection stands, or a UDP port was bound.
    Opened,

    // A piece of the connection's bytes, as it was received; over UDP a datagram.
    Bytes,

    // Here are bytes missing that were received.
    Lost,

    // The connection ended.
    Closed,

    // Nothing follows.
    End,
}

// One thing that happened while the stream was recorded, with its time since the start. Bytes and sender are valid until the next one is read.
internal readonly record struct RecordedEvent(RecordedEventKind Kind, TimeSpan Time)
{
    public TransportKind Transport { get; init; }

    // Number of the connection that it belongs to.
    public int Connection { get; init; }

    // Whether that is the one of a calculation port, beside another one.
    public bool IsCalculation { get; init; }

    // Of one that was opened: whether it stood before. Its first bytes may then be the middle of anything.
    public bool WasOpen { get; init; }

    public ArraySegment<byte> Bytes { get; init; }

    // Over UDP.
    public SocketAddress? Sender { get; init; }

    // Of one that was closed: why, in words; may be empty.
    public string? Reason { get; init; }
}
