namespace NeuronMocap;

/// <summary>Why a reader's connection is in its state.</summary>
public enum ConnectionReason
{
    /// <summary>Nothing went wrong.</summary>
    None,

    /// <summary>The caller stopped the reader.</summary>
    Requested,

    /// <summary>The address answered that nothing listens on the port.</summary>
    Refused,

    /// <summary>The address did not answer within the time of the connect option.</summary>
    TimedOut,

    /// <summary>The host name has no address.</summary>
    HostNotFound,

    /// <summary>There is no route to the address.</summary>
    Unreachable,

    /// <summary>The server cut the connection off.</summary>
    Reset,

    /// <summary>The server closed the connection in an orderly way.</summary>
    ClosedByPeer,

    /// <summary>A recording is over that was played instead of a live stream, or begins again.</summary>
    EndOfRecording,

    /// <summary>Another program uses the local port.</summary>
    PortInUse,

    /// <summary>The local address to bind does not belong to this machine.</summary>
    AddressUnavailable,

    /// <summary>The system does not allow the operation: a privileged port, or a firewall.</summary>
    AccessDenied,

    /// <summary>Connected, but no bytes arrive.</summary>
    NoData,

    /// <summary>Connected and bytes arrive, but they are no packets of this protocol.</summary>
    UnknownFormat,

    /// <summary>Datagrams arrive, but only from senders that AllowedSenders does not list.</summary>
    SenderNotAllowed,

    /// <summary>
    /// Frames arrive, but the rotation order of the reader's options is not the one that the server says it sends: all poses come out wrong
    /// unless the option is right.
    /// </summary>
    RotationOrderMismatch,

    /// <summary>
    /// Frames arrive, but the skeleton variant of the reader's options is not the one that the command channel tells: neck and spine have other
    /// names and lengths.
    /// </summary>
    SkeletonVariantMismatch,

    /// <summary>
    /// Frames arrive, but the command channel did not answer what they do not say: the rotation order or the skeleton variant may be another
    /// than is assumed.
    /// </summary>
    NotDiscovered,

    /// <summary>
    /// Connected, but the port of calculation data, CalculationPort, brings none: the message says why. Only where nothing else is wrong.
    /// </summary>
    CalculationUnavailable,

    /// <summary>Another error of the network; the message carries the system's words.</summary>
    NetworkError,
}
