using System.Net;
using System.Net.Sockets;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Examines each step on the way to a TCP server, from its name to its frames. If a step fails, it looks at other places.
internal sealed class TcpExamination(DiagnosisContext context)
{
    // No real server has more addresses.
    private const int MaxAddresses = 4;

    private readonly LinkOptions _link = context.Link;

    private StreamEndpoint Place => new(TransportKind.Tcp, _link.Host, _link.Port);

    public async Task<Conclusion> RunAsync()
    {
        (IPAddress[] addresses, Conclusion? unknown) = await ResolveAsync().ConfigureAwait(false);
        if (unknown is not null)
            return unknown;

        IPAddress[] routed = FindRoutes(addresses, out ConnectionReason reason);
        if (routed.Length == 0)
            return TcpConclusions.NoRoute(context, reason);

        TcpLink[] links = [.. routed.Select(Open)];
        try
        {
            (TcpLink? link, IPAddress address, LinkEnd failure) = await ConnectAsync(links, routed).ConfigureAwait(false);
            if (link is null)
                return await TcpConclusions.NotConnectedAsync(context, failure, address).ConfigureAwait(false);

            return await ListenAsync(link, address).ConfigureAwait(false);
        }
        finally
        {
            foreach (TcpLink link in links)
                link.Dispose();
        }

        TcpLink Open(IPAddress address) =>
            new(_link with { Host = address.ToString(), Tls = _link.Tls?.For(_link.Host), ConnectTimeout = context.Share(context.Budget.Connecting) });
    }

    private async Task<(IPAddress[] Addresses, Conclusion? Unknown)> ResolveAsync()
    {
        if (IPAddress.TryParse(_link.Host, out IPAddress? literal))
        {
            string text = literal.ToString();
            if (literal.AddressFamily == AddressFamily.InterNetwork && !text.Equals(_link.Host, StringComparison.Ordinal))
                context.Log.Warning("name", $"{_link.Host} is read as the address {text}");
            else
                context.Log.Ok("name", $"{text} is an address; no name to look up");
            return ([literal], null);
        }

        try
        {
            LinkOptions limited = _link with { ConnectTimeout = context.Share(context.Budget.Name) };
            IPAddress[] addresses = await HostResolver.ResolveAsync(limited, context.CancellationToken).ConfigureAwait(false);
            if (addresses.Length > 0)
            {
                context.Log.Ok("name", $"{_link.Host} has the address {string.Join(", ", addresses.Take(MaxAddresses).Select(Written))}");
                return ([.. addresses.Take(MaxAddresses)], null);
            }
        }
        catch (Exception exception) when (exception is SocketException or ArgumentException or TimeoutException)
        {
            context.CancellationToken.ThrowIfCancellationRequested();
            return ([], TcpConclusions.UnknownHost(context, exception));
        }

        return ([], TcpConclusions.UnknownHost(context, exception: null));
    }

    private IPAddress[] FindRoutes(IPAddress[] addresses, out ConnectionReason reason)
    {
        reason = ConnectionReason.None;
        var routed = new List<IPAddress>();
        IPAddress? used = null;
        var details = new List<string>();
        IReadOnlyList<OwnNetwork> networks = OwnNetwork.FindAll();
        foreach (IPAddress address in addresses)
        {
            ConnectionReason failure = LocalNetwork.FindRoute(address, _link.Port, _link.LocalAddress, out IPAddress? local);
            string to = addresses.Length > 1 ? $"to {Written(address)} " : string.Empty;
            if (local is null)
            {
                reason = failure;
                details.Add($"{to}no route");
                continue;
            }

            routed.Add(address);
            used ??= local;
            details.Add($"{to}{LocalNetwork.DescribeRoute(networks, local, address)}");
        }

        if (routed.Count > 0)
            context.Log.Ok("route", string.Join("; ", details));

        // Inside this computer, its networks do not matter.
        IPAddress remote = routed.Count > 0 ? routed[0] : addresses[0];
        if (!IPAddress.IsLoopback(remote))
            NetworksStep.Add(context.Log, networks, used, remote);

        return [.. routed];
    }

    // Connects to all addresses at once and takes the first in their order that connects. An address without an answer must not use up the time of the
    // next one.
    private async Task<(TcpLink? Link, IPAddress Address, LinkEnd Failure)> ConnectAsync(TcpLink[] links, IPAddress[] addresses)
    {
        Task<LinkEnd>[] opening = [.. links.Select(link => link.OpenAsync(context.CancellationToken))];
        var ends = new List<LinkEnd>();
        while (ends.Count < links.Length && (ends.Count == 0 || ends[^1].Reason != ConnectionReason.None))
            ends.Add(await opening[ends.Count].ConfigureAwait(false));

        context.CancellationToken.ThrowIfCancellationRequested();
        if (ends[^1].Reason != ConnectionReason.None)
        {
            int telling = Math.Max(0, ends.FindIndex(static end => end.Reason == ConnectionReason.Refused));
            return (null, addresses[telling], ends[telling]);
        }

        int connected = ends.Count - 1;
        for (int i = 0; i < links.Length; i++)
        {
            if (i != connected)
                links[i].Close();
        }

        if (connected > 0)
        {
            context.Log.Warning(
                "port",
                $"TCP port {_link.Port} of {Written(addresses[connected])} is open, but {Written(addresses[0])}, which a reader tries first, "
                + $"{(ends[0].Reason == ConnectionReason.Refused ? "refuses" : "does not answer")}: give the address instead of the name");
        }
        else
        {
            context.Log.Ok("port", $"TCP port {_link.Port} of {Written(addresses[connected])} is open");
        }

        return (links[connected], addresses[connected], LinkEnd.None);
    }

    private async Task<Conclusion> ListenAsync(TcpLink link, IPAddress address)
    {
        (StreamSample sample, TimeSpan silence, bool closedByServer, _) = await LinkSample.TakeAsync(context, link).ConfigureAwait(false);
        if (sample.Bytes == 0)
        {
            return closedByServer
                ? await TcpConclusions.ClosedAsync(context, address).ConfigureAwait(false)
                : await TcpConclusions.SilentAsync(context, address, silence).ConfigureAwait(false);
        }

        context.Log.Ok("first bytes", $"{sample.FirstBytes}{(closedByServer ? "; then the server closed the connection" : string.Empty)}");
        return await TcpConclusions.AddOtherPortsAsync(context, StreamExamination.Judge(context, sample, Place), address, isUdp: false).ConfigureAwait(false);
    }

    private static string Written(IPAddress address) =>
        address.AddressFamily == AddressFamily.InterNetworkV6 ? $"[{address}]" : address.ToString();
}
