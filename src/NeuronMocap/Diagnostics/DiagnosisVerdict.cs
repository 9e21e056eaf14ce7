namespace NeuronMocap.Diagnostics;

/// <summary>What a diagnosis found. With the values below 100 the frames that were asked for arrive; the others are faults.</summary>
public enum DiagnosisVerdict
{
    /// <summary>Frames arrive, and nothing is wrong with them.</summary>
    Receiving,

    /// <summary>Frames arrive with the old header (data version 1.0), which has no frame index: losses cannot be seen.</summary>
    OldHeader,

    /// <summary>Frames arrive as lines of text ("String"), which have no frame index and few digits: losses cannot be seen.</summary>
    TextFormat,

    /// <summary>Frames arrive whose number of values is none of those of the 59-bone skeleton.</summary>
    UnusualValueCount,

    /// <summary>Frames arrive, and between them bytes that belong to no packet.</summary>
    ForeignBytes,

    /// <summary>Frames arrive from more than one program on the same UDP port.</summary>
    SeveralSenders,

    /// <summary>Frames arrive at less than 54 per second, where a suit gives 60, 96 or 120.</summary>
    LowRate,

    /// <summary>Frames arrive, but more than one in a hundred is lost on the way.</summary>
    LosingFrames,

    /// <summary>Frames arrive, but all are the same: the pose or the frame index does not change.</summary>
    Motionless,

    /// <summary>Frames arrive, but the port of calculation data, CalculationPort, brings none.</summary>
    CalculationUnavailable,

    /// <summary>The host name has no address, or the name server gave no answer.</summary>
    HostNotFound = 100,

    /// <summary>There is no route to the address.</summary>
    Unreachable,

    /// <summary>The address did not answer: a wrong address, a firewall, or a computer that is switched off.</summary>
    NoAnswer,

    /// <summary>The address answered that nothing listens on the port.</summary>
    Refused,

    /// <summary>Another program on this computer uses the UDP port.</summary>
    PortInUse,

    /// <summary>The local address does not belong to this computer.</summary>
    LocalAddressUnavailable,

    /// <summary>The system does not allow the connection or the port.</summary>
    AccessDenied,

    /// <summary>The server accepts the connection and closes it without a byte.</summary>
    ClosedImmediately,

    /// <summary>Connected, or the UDP port is open, and not one byte arrives.</summary>
    Silent,

    /// <summary>Datagrams arrive, but only from senders that AllowedSenders does not list.</summary>
    SenderNotAllowed,

    /// <summary>Nothing on the port, but frames come from another port of the same kind.</summary>
    OtherPort,

    /// <summary>Nothing over TCP, but the stream arrives as datagrams on this computer.</summary>
    SentOverUdp,

    /// <summary>No datagrams, but the host offers the stream over TCP.</summary>
    OfferedOverTcp,

    /// <summary>Packets arrive, but none of them carries values.</summary>
    NoValues,

    /// <summary>Only calculation frames arrive where motion frames were asked for.</summary>
    CalculationOnly,

    /// <summary>Only motion frames arrive where calculation frames were asked for.</summary>
    MotionOnly,

    /// <summary>Only Axis Studio's calculation frames arrive where others were asked for.</summary>
    StudioCalculationOnly,

    /// <summary>The stream is text ("String"), but no line of it holds the values of the 59 bones, or they cannot be told from the avatar's name.</summary>
    MalformedText,

    /// <summary>Packets of a data version that this library does not know.</summary>
    UnknownVersion,

    /// <summary>Packets that announce more values than the reader's limit.</summary>
    TooManyValues,

    /// <summary>Only the first parts of packets arrive.</summary>
    IncompletePackets,

    /// <summary>The port is the server's command port.</summary>
    CommandPort,

    /// <summary>Another program listens or sends there: a web server, SSH, an encrypted service, ...</summary>
    OtherProgram,

    /// <summary>Bytes arrive that are no packets of this protocol, and of no format that is known.</summary>
    UnknownFormat,

    /// <summary>Another error of the network; the summary carries the system's words.</summary>
    NetworkError,

    /// <summary>Axis Studio's "Advanced BVH" arrives, another stream than its BVH broadcasting, which this library does not read.</summary>
    AdvancedBvh,
}
