using System.Net;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Examines each step from this computer's UDP port to the frames. If nothing arrives, it looks at other places.
internal sealed class UdpExamination(DiagnosisContext context, IReadOnlyList<IPAddress> allowedSenders)
{
    private readonly LinkOptions _link = context.Link;
    private readonly DatagramAddresses _addresses = new(context.Link.LocalAddress, LocalNetwork.ReachableAddresses());

    public async Task<Conclusion> RunAsync()
    {
        context.Log.Ok("route", _addresses.Route);
        if (_link.LocalAddress is not { } bound || !IPAddress.IsLoopback(bound))
            NetworksStep.Add(context.Log, OwnNetwork.FindAll(), _link.LocalAddress, remote: null);

        var sample = new StreamSample(context.Expected);
        var filter = new SenderFilter(allowedSenders);
        using var listener = new UdpListener(_link, filter, sample);
        ConnectionReason reason = listener.Open();
        if (reason != ConnectionReason.None)
            return NotBound(reason);

        context.Log.Ok("port", $"UDP port {listener.Port} is free and open");
        ReceiveBufferStep.Add(context.Log, listener.ReceiveBufferSize);
        Task receiving = listener.ReceiveAsync();
        TimeSpan silence = context.Share(context.Budget.Silence);
        await context.WaitAsync(silence, sample.Started, receiving).ConfigureAwait(false);
        if (sample.Started.IsCompleted)
            await context.WaitAsync(context.Share(context.Budget.Measuring), receiving).ConfigureAwait(false);

        var endpoint = new StreamEndpoint(TransportKind.Udp, _link.Host, listener.Port);
        listener.Dispose();
        await receiving.ConfigureAwait(false);
        if (sample.Bytes == 0 && filter.RefusedDatagrams > 0)
            return NotAllowed(filter, endpoint);

        return sample.Bytes == 0
            ? await SilentAsync(listener, silence).ConfigureAwait(false)
            : await JudgeAsync(listener, sample, endpoint).ConfigureAwait(false);
    }

    private Task<Conclusion> JudgeAsync(UdpListener listener, StreamSample sample, StreamEndpoint endpoint)
    {
        string senders = string.Join(", ", listener.Senders);
        context.Log.Ok("first bytes", $"{sample.FirstBytes}, from {senders}, datagrams of up to {listener.LargestDatagram} bytes");
        return TcpConclusions.AddOtherPortsAsync(context, StreamExamination.Judge(context, sample, endpoint), address: null, isUdp: true);
    }

    private Conclusion NotAllowed(SenderFilter filter, StreamEndpoint endpoint)
    {
        string senders = string.Join(", ", filter.RefusedSenders);
        context.Log.Failed("first bytes", FormattableString.Invariant($"none from an allowed sender: {filter.RefusedDatagrams} datagrams from {senders}"));
        return new Conclusion(
            DiagnosisVerdict.SenderNotAllowed,
            $"Datagrams arrive on {endpoint}, but only from {senders}, which AllowedSenders does not list.",
            "If that is the computer that runs Axis Neuron, set AllowedSenders to its address, or leave it out to allow all senders.");
    }

    private Conclusion NotBound(ConnectionReason reason)
    {
        (DiagnosisVerdict verdict, string detail, string text, string? advice) = reason switch
        {
            ConnectionReason.PortInUse => (
                DiagnosisVerdict.PortInUse,
                "in use by another program",
                $"UDP port {_link.Port} of this computer is in use by another program, which gets the datagrams.",
                "Close that program. Or choose another port here, and the same port in the server's broadcasting settings as the client's or "
                + "destination's port."),
            ConnectionReason.AddressUnavailable => (
                DiagnosisVerdict.LocalAddressUnavailable,
                $"{_link.LocalAddress} is not an address of this computer",
                $"The local address {_link.LocalAddress} does not belong to this computer.",
                "Set LocalAddress to an address of this computer, or leave it out to receive on all."),
            ConnectionReason.AccessDenied => (
                DiagnosisVerdict.AccessDenied,
                "the system does not allow it",
                $"This computer does not allow UDP port {_link.Port}.",
                "Choose port 1024 or higher, here and on the server."),
            _ => (
                DiagnosisVerdict.NetworkError,
                "it cannot be opened",
                $"UDP port {_link.Port} of this computer cannot be opened ({reason}).",
                (string?)null),
        };
        context.Log.Failed("port", $"UDP port {_link.Port}: {detail}");
        return new Conclusion(verdict, text, advice);
    }

    private async Task<Conclusion> SilentAsync(UdpListener listener, TimeSpan silence)
    {
        context.Log.Failed("first bytes", $"none in {ConnectionMessages.Seconds(silence)}");
        IPAddress? host = await ResolveHostAsync().ConfigureAwait(false);
        PortScanResult search = await AlternativePortScan.FindAsync(context, host, isUdp: true).ConfigureAwait(false);
        if (search.Found is { } found && found.Sample.Has(context.Expected))
            return FoundElsewhereOnUdp(found);

        return new Conclusion(
            DiagnosisVerdict.Silent,
            $"Nothing arrives on UDP port {listener.Port} of this computer. The server sends nothing, or sends over TCP or to another address or port. Or a "
            + "firewall blocks the datagrams: the one of this computer, or one that drops datagrams of more than one network packet.",
            $"{ServerSettings.BroadcastUdp(context.Expected, _addresses.FromNetwork(listener.Port))} {_addresses.Advice(listener.Port)} Allow this program in this "
            + $"computer's firewall. {ServerSettings.Play}");
    }

    private static Conclusion FoundElsewhereOnUdp(PortProbe found)
    {
        ExplainedVerdict verdict = found.Endpoint.Transport == TransportKind.Udp
            ? new ExplainedVerdict(
                DiagnosisVerdict.OtherPort,
                $"Frames arrive on {found.Endpoint}, from {found.Sender}, not on the requested port.",
                $"Use port {found.Endpoint.Port} here, or change the client's or destination's port in the server's broadcasting settings.")
            : new ExplainedVerdict(
                DiagnosisVerdict.OfferedOverTcp,
                $"No datagram arrives, but {found.Endpoint} has the stream: the server is set to TCP.",
                $"Receive over TCP from {found.Endpoint.Host}, port {found.Endpoint.Port}; or choose UDP on the server.");
        return new Conclusion([verdict], Endpoint: found.Endpoint);
    }

    // A name that cannot be resolved is not a fault here, because UDP does not need it.
    private async Task<IPAddress?> ResolveHostAsync()
    {
        try
        {
            LinkOptions limited = _link with { ConnectTimeout = context.Share(context.Budget.Asking) };
            IPAddress[] addresses = await HostResolver.ResolveAsync(limited, context.CancellationToken).ConfigureAwait(false);
            return addresses.Length > 0 ? addresses[0] : null;
        }
        catch (Exception exception) when (exception is System.Net.Sockets.SocketException or ArgumentException or TimeoutException)
        {
            context.CancellationToken.ThrowIfCancellationRequested();
            return null;
        }
    }
}
