using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>Describes a status in the words of this program.</summary>
internal static class StatusWords
{
    /// <summary>Describes a status in one or two sentences that are safe for a terminal and name options of this program.</summary>
    public static string Describe(this ConnectionStatus status) => TerminalText.Clean(OptionNames.Translate(status.Message ?? string.Empty));

    /// <summary>Names the state, or the problem, in a few words.</summary>
    public static string Title(this ConnectionStatus status) => (status.State, status.Reason) switch
    {
        (ConnectionState.Receiving, _) => "Receiving",
        (ConnectionState.Connected, _) => "Connected, waiting for frames",
        (ConnectionState.Connecting or ConnectionState.Created, _) => "Connecting",
        (ConnectionState.Silent, ConnectionReason.UnknownFormat) => "Data arrives, but no frames",
        (ConnectionState.Silent, ConnectionReason.SenderNotAllowed) => "Sender not allowed",
        (ConnectionState.Silent, _) => "Nothing arrives",
        (_, ConnectionReason.Refused) => "Connection refused",
        (_, ConnectionReason.TimedOut) => "No answer",
        (_, ConnectionReason.HostNotFound) => "Host not found",
        (_, ConnectionReason.Unreachable) => "No route",
        (_, ConnectionReason.Reset or ConnectionReason.ClosedByPeer) => "Connection closed",
        (_, ConnectionReason.PortInUse) => "Port in use",
        (_, ConnectionReason.AddressUnavailable or ConnectionReason.AccessDenied) => "Not allowed",
        (_, ConnectionReason.CertificateRejected) => "Certificate rejected",
        (_, ConnectionReason.TlsFailed) => "No TLS",
        (_, ConnectionReason.EndOfRecording) => "End of the recording",
        (ConnectionState.Stopped, _) => "Stopped",
        _ => "No connection",
    };
}
