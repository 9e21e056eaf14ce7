#nullable enable


namespace NeuronMocap.Unity.EditorTools
{
    // Short titles for the states of a source, as in the monitor, and their severity.
    internal static class StateTitles
    {
        public static string Of(SourceState state, ConnectionReason reason) => (state, reason) switch
        {
            (SourceState.Receiving, ConnectionReason.RotationOrderMismatch) => "Receiving, with another rotation order",
            (SourceState.Receiving, ConnectionReason.SkeletonVariantMismatch) => "Receiving, with another skeleton variant",
            (SourceState.Receiving, ConnectionReason.CalculationUnavailable) => "Receiving, without calculation data",
            (SourceState.Receiving, _) => "Receiving",
            (SourceState.Loading, _) => "Reading the file",
            (SourceState.Connecting, _) => "Connecting",
            (SourceState.Connected, _) => "Connected, waiting for frames",
            (SourceState.Silent, ConnectionReason.UnknownFormat) => "Data arrives, but no frames",
            (SourceState.Silent, ConnectionReason.SenderNotAllowed) => "Sender not allowed",
            (SourceState.Silent, _) => "Nothing arrives",
            (SourceState.Ended, _) => "The file has ended",
            (SourceState.Closed, _) => "Closed",
            (_, ConnectionReason.Refused) => "Connection refused",
            (_, ConnectionReason.TimedOut) => "No answer",
            (_, ConnectionReason.HostNotFound) => "Host not found",
            (_, ConnectionReason.Unreachable) => "No route",
            (_, ConnectionReason.Reset or ConnectionReason.ClosedByPeer) => "Connection closed",
            (_, ConnectionReason.PortInUse) => "Port in use",
            (_, ConnectionReason.AddressUnavailable or ConnectionReason.AccessDenied) => "Not allowed",
            (SourceState.Failed, _) => "Failed",
            _ => "No connection",
        };

        public static Severity SeverityOf(SourceState state, ConnectionReason reason) => state switch
        {
            SourceState.Receiving when reason is ConnectionReason.RotationOrderMismatch or ConnectionReason.SkeletonVariantMismatch => Severity.Error,
            SourceState.Receiving when reason is ConnectionReason.NotDiscovered or ConnectionReason.CalculationUnavailable => Severity.Warning,
            SourceState.Receiving => Severity.Good,
            SourceState.Loading or SourceState.Connecting or SourceState.Connected => Severity.Waiting,
            SourceState.Silent => Severity.Warning,
            SourceState.Waiting or SourceState.Failed => Severity.Error,
            _ => Severity.None,
        };
    }
}
