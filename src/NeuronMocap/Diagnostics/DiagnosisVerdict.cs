namespace NeuronMocap.Diagnostics;

/// <summary>The result of a diagnosis. With values below 100, the requested frames arrive; all other values are faults.</summary>
public enum DiagnosisVerdict
{
    /// <summary>Frames arrive, and there is no problem.</summary>
    Receiving,

    /// <summary>Frames arrive with the old header (data version 1.0), which has no frame index. Lost frames cannot be detected.</summary>
    OldHeader,

    /// <summary>Frames arrive as lines of text ("String"), which have no frame index and few digits. Lost frames cannot be detected.</summary>
    TextFormat,

    /// <summary>Frames arrive, but their number of values does not match the 59-bone skeleton.</summary>
    UnusualValueCount,

    /// <summary>Frames arrive, with bytes between them that are not packets.</summary>
    ForeignBytes,

    /// <summary>Frames arrive from more than one program on the same UDP port.</summary>
    SeveralSenders,

    /// <summary>Fewer than 54 frames per second arrive; a suit sends 60, 96 or 120.</summary>
    LowRate,

    /// <summary>Frames arrive, but more than one in a hundred is lost on the way.</summary>
    LosingFrames,

    /// <summary>Frames arrive, but all are the same: the pose or the frame index does not change.</summary>
    Motionless,

    /// <summary>Frames arrive, but no calculation data arrives on its port, CalculationPort.</summary>
    CalculationUnavailable,

    /// <summary>The host name has no address, or no name server answered.</summary>
    HostNotFound = 100,

    /// <summary>There is no route to the address.</summary>
    Unreachable,

    /// <summary>The address did not answer. The address is wrong, a firewall blocks it, or the computer is switched off.</summary>
    NoAnswer,

    /// <summary>The computer refused the connection: nothing listens on the port.</summary>
    Refused,

    /// <summary>Another program on this computer uses the UDP port.</summary>
    PortInUse,

    /// <summary>The local address does not belong to this computer.</summary>
    LocalAddressUnavailable,

    /// <summary>The system does not allow the connection or the port.</summary>
    AccessDenied,

    /// <summary>The server accepts the connection and closes it without sending a byte.</summary>
    ClosedImmediately,

    /// <summary>Connected, or the UDP port is open, but not a single byte arrives.</summary>
    Silent,

    /// <summary>Datagrams arrive, but only from senders that AllowedSenders does not list.</summary>
    SenderNotAllowed,

    /// <summary>Nothing arrives on the port, but frames arrive on another port of the same kind.</summary>
    OtherPort,

    /// <summary>Nothing arrives over TCP, but the stream arrives as datagrams on this computer.</summary>
    SentOverUdp,

    /// <summary>No datagrams arrive, but the host offers the stream over TCP.</summary>
    OfferedOverTcp,

    /// <summary>Packets arrive, but none of them contains values.</summary>
    NoValues,

    /// <summary>Motion frames were requested, but only calculation frames arrive.</summary>
    CalculationOnly,

    /// <summary>Calculation frames were requested, but only motion frames arrive.</summary>
    MotionOnly,

    /// <summary>Other frames were requested, but only Axis Studio's calculation frames arrive.</summary>
    StudioCalculationOnly,

    /// <summary>
    /// The stream is text ("String"), but no line contains the values of the 59 bones, or the values cannot be distinguished from the avatar's name.
    /// </summary>
    MalformedText,

    /// <summary>Packets arrive with a data version that this library does not support.</summary>
    UnknownVersion,

    /// <summary>Packets arrive that announce more values than the reader's limit.</summary>
    TooManyValues,

    /// <summary>Only the first parts of packets arrive.</summary>
    IncompletePackets,

    /// <summary>The port is the server's command port.</summary>
    CommandPort,

    /// <summary>Another program listens or sends there: a web server, SSH or an encrypted service, for example.</summary>
    OtherProgram,

    /// <summary>Bytes arrive that are not packets of this protocol, and that have no known format.</summary>
    UnknownFormat,

    /// <summary>Another network error; the summary contains the system's text.</summary>
    NetworkError,

    /// <summary>Axis Studio's "Advanced BVH" arrives. This stream differs from its BVH broadcasting, and this library does not support it.</summary>
    AdvancedBvh,
}
