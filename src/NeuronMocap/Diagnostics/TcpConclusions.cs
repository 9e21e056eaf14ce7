using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Conclusions for a TCP port that sends no bytes, including the search at other places.
internal static class TcpConclusions
{
    public static Conclusion UnknownHost(DiagnosisContext context, Exception? exception)
    {
        string host = context.Link.Host;
        const string GiveAddress =
            "give the IP address of the computer that runs Axis Neuron or Axis Studio (there, ipconfig in a command window shows it).";
        if (host.Contains(':', StringComparison.Ordinal) || host.Contains('/', StringComparison.Ordinal))
        {
            context.Log.Failed("name", $"'{host}' is not a host name");
            return new Conclusion(
                DiagnosisVerdict.HostNotFound,
                $"'{host}' is neither a host name nor an address.",
                "Host must be only a name or an address; the port is a separate option.");
        }

        if (exception is TimeoutException or SocketException { SocketErrorCode: SocketError.TryAgain })
        {
            context.Log.Failed("name", $"no name server answers for '{host}'");
            return new Conclusion(
                DiagnosisVerdict.HostNotFound,
                $"The name '{host}' could not be looked up: no name server answers.",
                $"Check this computer's network, or {GiveAddress}");
        }

        context.Log.Failed("name", $"'{host}' has no address");
        return new Conclusion(
            DiagnosisVerdict.HostNotFound, $"The host name '{host}' has no address.", $"Check its spelling, or {GiveAddress}");
    }

    public static Conclusion NoRoute(DiagnosisContext context, ConnectionReason reason)
    {
        if (reason == ConnectionReason.AccessDenied)
        {
            context.Log.Failed("route", "this computer does not allow it");
            return new Conclusion(
                DiagnosisVerdict.AccessDenied,
                $"This computer does not allow a connection to {context.Link.Host}.",
                "Check the address: the address of a whole network (such as 192.168.1.255) is not a server's address. Then check this computer's firewall.");
        }

        if (context.Link.LocalAddress is { } local && reason != ConnectionReason.Unreachable)
        {
            context.Log.Failed("route", $"{local} cannot be the sender");
            return new Conclusion(
                DiagnosisVerdict.LocalAddressUnavailable,
                $"The local address {local} does not belong to this computer, or is of another kind (IPv4, IPv6) than the server's.",
                "Set LocalAddress to an address of this computer, or leave it out.");
        }

        if (reason is not (ConnectionReason.Unreachable or ConnectionReason.AddressUnavailable))
        {
            context.Log.Failed("route", $"the system finds none ({reason})");
            return new Conclusion(
                DiagnosisVerdict.NetworkError,
                $"This computer cannot send to {context.Link.Host} ({reason}).",
                "Check the address. An IPv6 address needs IPv6 on this computer; a link-local address (fe80::…) also needs the number of its network (%2).");
        }

        context.Log.Failed("route", "none found");
        return new Conclusion(
            DiagnosisVerdict.Unreachable,
            $"This computer has no route to {context.Link.Host}.",
            "Check the address, and that the cable is plugged in or Wi-Fi is on. Both computers must be on the same network.");
    }

    public static async Task<Conclusion> NotConnectedAsync(DiagnosisContext context, LinkEnd failure, IPAddress address)
    {
        (DiagnosisVerdict verdict, string detail) = failure.Reason switch
        {
            ConnectionReason.Refused => (DiagnosisVerdict.Refused, "nothing listens there"),
            ConnectionReason.TimedOut => (DiagnosisVerdict.NoAnswer, "no answer"),
            ConnectionReason.Unreachable => (DiagnosisVerdict.Unreachable, "the computer cannot be reached"),
            ConnectionReason.AddressUnavailable => (DiagnosisVerdict.LocalAddressUnavailable, "the local address does not fit"),
            ConnectionReason.AccessDenied => (DiagnosisVerdict.AccessDenied, "this computer does not allow the connection"),
            _ => (DiagnosisVerdict.NetworkError, failure.Message),
        };
        context.Log.Failed("port", $"TCP port {context.Link.Port}: {detail}");
        PortScanResult search = await AlternativePortScan.FindAsync(context, address, isUdp: false).ConfigureAwait(false);
        ExplainedVerdict plain = verdict switch
        {
            DiagnosisVerdict.Refused => new ExplainedVerdict(
                verdict,
                $"{context.Link.Target} refuses the connection: nothing listens on that port. Axis Neuron or Axis Studio does not run there, or its "
                + "broadcasting is off, set to UDP, or on another port.",
                $"{ServerSettings.BroadcastTcp(context.Expected, context.Link.Port, !IPAddress.IsLoopback(address))}{OtherComputer(address)}"),
            DiagnosisVerdict.NoAnswer => NoAnswer(context, address, search.HostAnswers),
            DiagnosisVerdict.Unreachable => new ExplainedVerdict(
                verdict,
                $"{context.Link.Target} cannot be reached: the network says that there is no such computer.",
                "Check the address, that the computer is switched on, and that both computers are on the same network."),
            _ => new ExplainedVerdict(verdict, failure.Message),
        };
        return Conclude(context, plain, search);
    }

    public static async Task<Conclusion> ClosedAsync(DiagnosisContext context, IPAddress address)
    {
        context.Log.Failed("first bytes", "none: the server closed the connection");
        PortScanResult search = await AlternativePortScan.FindAsync(context, address, isUdp: false).ConfigureAwait(false);
        var plain = new ExplainedVerdict(
            DiagnosisVerdict.ClosedImmediately,
            $"{context.Link.Target} accepts the connection and closes it without sending anything. Possible causes are a forwarded port (a container, a VPN, "
            + "a tunnel) with nothing listening behind it, a server that accepts no more clients, or another program.",
            "Close other programs that receive the stream, check the port, and connect to the server itself. "
            + $"{ServerSettings.BroadcastTcp(context.Expected, context.Link.Port, !IPAddress.IsLoopback(address))}");
        return Conclude(context, plain, search);
    }

    public static async Task<Conclusion> SilentAsync(DiagnosisContext context, IPAddress address, TimeSpan silence)
    {
        context.Log.Failed("first bytes", $"none in {ConnectionMessages.Seconds(silence)}");
        if (context.Options.SearchOtherPorts && await ServerProbe.AskAsync(context, address).ConfigureAwait(false) is { } answer)
            return await AddOtherPortsAsync(context, Answered(context, answer), address, isUdp: false).ConfigureAwait(false);

        if (context.Options.SearchOtherPorts)
            context.Log.Ok("question", "the server does not answer requests");

        PortScanResult search = await AlternativePortScan.FindAsync(context, address, isUdp: false).ConfigureAwait(false);
        var plain = new ExplainedVerdict(
            DiagnosisVerdict.Silent,
            $"{context.Link.Target} accepts the connection, but sends nothing: most likely no suit is connected and calibrated and no take is played.",
            $"{ServerSettings.Play} If the avatar moves in the server's window, its BVH broadcasting is off for this port. "
            + ServerSettings.BroadcastTcp(context.Expected, context.Link.Port, isRemote: false));
        return Conclude(context, plain, search);
    }

    // Something else arrives on this port; another port may have the frames.
    public static async Task<Conclusion> AddOtherPortsAsync(DiagnosisContext context, Conclusion conclusion, IPAddress? address, bool isUdp)
    {
        if (!conclusion.Verdicts[0].IsFault)
            return conclusion;

        PortScanResult search = await AlternativePortScan.FindAsync(context, address, isUdp).ConfigureAwait(false);
        if (search.Found is not { } found || !found.Sample.Has(context.Expected))
            return conclusion;

        ExplainedVerdict instead = found.Endpoint.Transport == TransportKind.Udp
            ? new ExplainedVerdict(
                DiagnosisVerdict.SentOverUdp,
                $"Frames arrive on {found.Endpoint} instead, from {found.Sender}.",
                $"Receive over UDP on port {found.Endpoint.Port} here.")
            : new ExplainedVerdict(DiagnosisVerdict.OtherPort, $"Frames arrive on {found.Endpoint} instead.", $"Use port {found.Endpoint.Port} over TCP here.");
        return conclusion with { Verdicts = [.. conclusion.Verdicts, instead], Endpoint = found.Endpoint };
    }

    private static Conclusion Answered(DiagnosisContext context, StreamSample answer)
    {
        FormatGuess guess = answer.Guess();
        string quoted = answer.Quote() is { } quote ? $" (\"{quote}\")" : string.Empty;
        if (guess.Format == ForeignFormat.CommandReply)
        {
            context.Log.Failed("question", "the server answers a request for the rotation order: this is a command port");
            return new Conclusion(
                DiagnosisVerdict.CommandPort,
                $"{context.Link.Target} is the server's command port: it answers commands and never sends frames.",
                ServerSettings.DataPort);
        }

        string answers = guess.Format == ForeignFormat.OtherProgram ? guess.Text : $"bytes that no motion capture server sends, {answer.FirstBytes}";
        context.Log.Failed("question", $"the server answers a request with {answers}{quoted}");
        return new Conclusion(
            DiagnosisVerdict.OtherProgram,
            $"Another program listens on {context.Link.Target}. It sends nothing before a request, and then {answers}{quoted}.",
            $"Check the port against the one in the server's broadcasting settings; it is usually {ProtocolConstants.DefaultPort}.");
    }

    private static ExplainedVerdict NoAnswer(DiagnosisContext context, IPAddress address, bool hostAnswers)
    {
        string where = hostAnswers
            ? "The computer itself answers on other ports, so a firewall blocks this one, or nothing listens there."
            : "The address is wrong, the computer is switched off or on another network, or a firewall drops the connection (that of Windows also "
                + "does when nothing listens).";
        return new ExplainedVerdict(
            DiagnosisVerdict.NoAnswer,
            $"{context.Link.Target} does not answer. {where}",
            "On that computer, allow Axis Neuron or Axis Studio in Windows Defender Firewall (private networks), and check that it broadcasts. "
            + ServerSettings.BroadcastTcp(context.Expected, context.Link.Port, !IPAddress.IsLoopback(address)));
    }

    // A stream that was found at another place explains more than the silence at this one.
    private static Conclusion Conclude(DiagnosisContext context, ExplainedVerdict plain, in PortScanResult search)
    {
        if (search.Found is not { } found)
            return new Conclusion([search.AdvancedBvh is { } other ? AddAdvancedBvh(plain, other) : plain]);
        if (!found.Sample.Has(context.Expected))
        {
            return new Conclusion([plain with
            {
                Text = $"{plain.Text} The server does run: {found.Endpoint} has {StreamPhrases.KindsOf(found.Sample)}.",
            }]);
        }

        string instead = $"Nothing arrives from TCP port {context.Link.Port}, but frames arrive on {found.Endpoint}";
        ExplainedVerdict better = found.Endpoint.Transport == TransportKind.Tcp
            ? new ExplainedVerdict(
                DiagnosisVerdict.OtherPort,
                $"{instead}.",
                $"Use port {found.Endpoint.Port} here, or set the port in the server's broadcasting settings to {context.Link.Port}.")
            : new ExplainedVerdict(
                DiagnosisVerdict.SentOverUdp,
                $"{instead}, from {found.Sender}: the server is set to UDP.",
                $"Receive over UDP on port {found.Endpoint.Port} here, or choose TCP on the server. "
                + ServerSettings.BroadcastTcp(context.Expected, context.Link.Port, isRemote: false));
        return new Conclusion([better], Endpoint: found.Endpoint);
    }

    private static ExplainedVerdict AddAdvancedBvh(ExplainedVerdict plain, PortProbe probe)
    {
        FormatGuess guess = probe.Sample.Guess();
        return plain with { Text = $"{plain.Text} The server does run: {probe.Endpoint} has {guess.Text}.", Advice = guess.Advice };
    }

    private static string OtherComputer(IPAddress address) => IPAddress.IsLoopback(address)
        ? $" {address} is this computer: if the server runs on another one, give its address."
        : string.Empty;
}
