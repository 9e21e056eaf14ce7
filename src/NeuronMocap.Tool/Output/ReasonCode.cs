namespace NeuronMocap.Tool.Output;

/// <summary>The names of reasons for scripts. They stay the same when members are renamed.</summary>
internal static class ReasonCode
{
    public static string Of(ConnectionReason reason) => reason switch
    {
        ConnectionReason.None => "none",
        ConnectionReason.Requested => "requested",
        ConnectionReason.Refused => "refused",
        ConnectionReason.TimedOut => "timed-out",
        ConnectionReason.HostNotFound => "host-not-found",
        ConnectionReason.Unreachable => "unreachable",
        ConnectionReason.Reset => "reset",
        ConnectionReason.ClosedByPeer => "closed-by-peer",
        ConnectionReason.EndOfRecording => "end-of-recording",
        ConnectionReason.PortInUse => "port-in-use",
        ConnectionReason.AddressUnavailable => "address-unavailable",
        ConnectionReason.AccessDenied => "access-denied",
        ConnectionReason.NoData => "no-data",
        ConnectionReason.UnknownFormat => "unknown-format",
        ConnectionReason.SenderNotAllowed => "sender-not-allowed",
        ConnectionReason.RotationOrderMismatch => "rotation-order-mismatch",
        ConnectionReason.SkeletonVariantMismatch => "skeleton-variant-mismatch",
        ConnectionReason.NotDiscovered => "not-discovered",
        ConnectionReason.CalculationUnavailable => "calculation-unavailable",
        ConnectionReason.CertificateRejected => "certificate-rejected",
        ConnectionReason.TlsFailed => "tls-failed",
        ConnectionReason.NetworkError => "network-error",
        _ => "other",
    };
}
