namespace NeuronMocap;

/// <summary>The reason why a reader's connection is in its state.</summary>
public enum ConnectionReason
{
    /// <summary>There is no problem.</summary>
    None,

    /// <summary>The caller stopped the reader.</summary>
    Requested,

    /// <summary>The computer refused the connection: nothing listens on the port.</summary>
    Refused,

    /// <summary>The address did not answer within the connect timeout.</summary>
    TimedOut,

    /// <summary>The host name has no address.</summary>
    HostNotFound,

    /// <summary>There is no route to the address.</summary>
    Unreachable,

    /// <summary>The server reset the connection.</summary>
    Reset,

    /// <summary>The server closed the connection normally, or the stream of a source has ended.</summary>
    ClosedByPeer,

    /// <summary>The played recording has ended, or starts again.</summary>
    EndOfRecording,

    /// <summary>Another program uses the local port.</summary>
    PortInUse,

    /// <summary>The local address to bind does not belong to this computer.</summary>
    AddressUnavailable,

    /// <summary>The system does not allow the operation: a privileged port, or a firewall.</summary>
    AccessDenied,

    /// <summary>Connected, but no bytes arrive.</summary>
    NoData,

    /// <summary>Connected, and bytes arrive, but they are not packets of this protocol.</summary>
    UnknownFormat,

    /// <summary>Datagrams arrive, but only from senders that AllowedSenders does not list.</summary>
    SenderNotAllowed,

    /// <summary>
    /// Frames arrive, but the rotation order in the reader's options differs from the order that the server reports. If the option is wrong, all poses are
    /// wrong.
    /// </summary>
    RotationOrderMismatch,

    /// <summary>
    /// Frames arrive, but the skeleton variant in the reader's options differs from the variant that the command channel reports. Neck and spine then have
    /// other names and lengths.
    /// </summary>
    SkeletonVariantMismatch,

    /// <summary>
    /// Frames arrive, but the command channel did not report the settings that they do not contain. The assumed rotation order or skeleton variant may be
    /// wrong.
    /// </summary>
    NotDiscovered,

    /// <summary>
    /// Connected, but no calculation data arrives on its port, CalculationPort; the message says why. Set only if there is no other problem.
    /// </summary>
    CalculationUnavailable,

    /// <summary>
    /// The server's TLS certificate is not accepted: it has expired, has another name, or comes from somebody whom this computer does not trust. The message
    /// says which.
    /// </summary>
    CertificateRejected,

    /// <summary>The server does not speak TLS, or no version of it that this computer allows.</summary>
    TlsFailed,

    /// <summary>Another error of the network or of a source; the message contains its text.</summary>
    NetworkError,
}
