using System.Net;

namespace NeuronMocap.Transport;

// The messages that tell a person what happened and which setting to check.
internal static class ConnectionMessages
{
    public static string HostNotFound(string host) =>
        $"The host name '{host}' has no address. Check its spelling, or give the IP address of the computer that runs Axis Neuron.";

    public static string ClosedByPeer(string target) =>
        $"{target} closed the connection: Axis Neuron was stopped, or its broadcasting was switched off.";

    public static string ConnectionLost(string target) =>
        $"{target} has stopped answering: its computer was switched off, or the network between the computers is down.";

    public static string ResolverTimedOut(LinkOptions options) =>
        $"The name '{options.Host}' could not be resolved within {Seconds(options.ConnectTimeout)}. Check the network, or give the IP "
        + "address of the computer that runs Axis Neuron.";

    public static string TlsFailed(string target, Exception exception) =>
        $"{target} does not speak TLS, or not as this computer demands ({exception.GetBaseException().Message.TrimEnd('.')}). Axis Neuron and Axis Studio do not encrypt: "
        + "connect to them without Tls.";

    public static string NotYetAnswered(string status) =>
        $"{status} Nothing has answered yet: check Host and Port, that both computers are on the same network, and that no firewall blocks the port.";

    public static string NotYetOpened(string status) => $"{status} It has not opened yet: check the device, the program or the tunnel that it opens.";

    // The network never causes these exceptions, and their messages do not help a user.
    public static string Failed(string target, Exception exception) => exception is OutOfMemoryException
        ? $"Receiving from {target} failed: this computer has too little free memory."
        : $"Receiving from {target} failed because of an error in this library ({exception.GetType()}). Please report it.";

    // For what the application opens: a file may be damaged, a stream may fail. The exception's message says so.
    public static string ReceivingFailed(string target, Exception exception) => $"Receiving from {target} failed: {exception.Message}";

    public static string NotOpened(string target, Exception exception) => $"Opening {target} failed: {exception.Message}";

    public static string EndOfBytes(string target) => $"Receiving from {target} has ended: there are no more bytes.";

    public static string NoValues(string target) =>
        $"Packets arrive from {target}, but none of them contains a frame. In Axis Neuron, connect the suit or play a take.";

    public static string NoFrames(string target, TimeSpan silence) =>
        $"Connected to {target}, but nothing has arrived for {Seconds(silence)}. In Axis Neuron, connect the suit or play a take. "
        + "Check that broadcasting of BVH or calculation data is on, and that this is its port, not the command port.";

    public static string NoBytes(string target, TimeSpan silence) =>
        $"Nothing has arrived from {target} for {Seconds(silence)}. Check that the program that writes to it runs, and that it sends BVH or "
        + "calculation data.";

    public static string NoRecordedFrames(string target, TimeSpan silence) =>
        $"The {target} has had no frame for {Seconds(silence)}: nothing arrived while it was recorded.";

    public static string NoDatagrams(string target, TimeSpan silence, long refused) =>
        $"Nothing has arrived on {target} for {Seconds(silence)}"
        + (refused > 0 ? $", except a few datagrams from senders that AllowedSenders does not list ({refused} in all). " : ". ")
        + "In Axis Neuron's broadcasting settings choose UDP, and enter this computer's address and this port as the destination. Check that "
        + "the firewall allows UDP.";

    public static string SenderNotAllowed(string target, IEnumerable<IPAddress> senders) =>
        $"Datagrams arrive on {target}, but none from a sender that AllowedSenders lists. They come from {string.Join(", ", senders)}. Set AllowedSenders to "
        + "the address of the computer that runs Axis Neuron, or leave it out to allow all senders.";

    public static string UnknownFormat(string target, string format) =>
        $"Data arrives from {target}, but it is {format}";

    public static string TcpFailed(ConnectionReason reason, LinkOptions options, Exception exception)
    {
        string target = options.Target;
        return reason switch
        {
            ConnectionReason.Refused when options.Tls is not null =>
                $"{target} refused the connection: nothing listens there. Check the address and the port of the server.",
            ConnectionReason.Refused =>
                $"{target} refused the connection: nothing listens there. In Axis Neuron's broadcasting settings switch BVH on, choose TCP, "
                + "and check that the port is the same.",
            ConnectionReason.TimedOut when options.Tls is not null =>
                $"{target} did not answer with TLS within {Seconds(options.ConnectTimeout)}. Check the address and the port, that no firewall blocks the "
                + "port, and that this server encrypts its stream.",
            ConnectionReason.TimedOut =>
                $"{target} did not answer within {Seconds(options.ConnectTimeout)}. Check the address, that both computers are on the "
                + "same network, and that no firewall blocks the port.",
            ConnectionReason.HostNotFound => HostNotFound(options.Host),
            ConnectionReason.Unreachable => $"No route to {target}. Check the address and that the network is connected.",
            ConnectionReason.Reset => $"{target} reset the connection: Axis Neuron was closed, or a device in the network resets connections.",
            ConnectionReason.AddressUnavailable when options.LocalAddress is null =>
                $"This computer has no address from which {target} can be reached. Check the address and the network.",
            ConnectionReason.AddressUnavailable =>
                $"The local address {options.LocalAddress} does not belong to this computer, or is of another kind (IPv4, IPv6) than {target}. "
                + "Choose an address of this computer, or none.",
            ConnectionReason.AccessDenied => $"This computer does not allow a connection to {target}. Check its firewall.",
            _ => $"The connection to {target} failed: {exception.Message}",
        };
    }

    public static string UdpFailed(ConnectionReason reason, LinkOptions options, Exception exception) => reason switch
    {
        ConnectionReason.PortInUse =>
            $"UDP port {options.Port} is in use by another program. Close it, or choose another port here and in Axis Neuron's broadcasting settings.",
        ConnectionReason.AddressUnavailable =>
            $"The local address {options.LocalAddress} does not belong to this computer. Choose an address of this computer, or none to receive on all.",
        ConnectionReason.AccessDenied => $"This computer does not allow UDP port {options.Port}. Choose port 1024 or higher.",
        _ => $"Receiving on UDP port {options.Port} failed: {exception.Message}",
    };

    // Messages are English in every culture: "0.5 s", not "0,5 s".
    public static string Seconds(TimeSpan time) => FormattableString.Invariant($"{time.TotalSeconds:0.###} s");
}
