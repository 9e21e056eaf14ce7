using System.Net;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// The result of another port.
internal sealed record PortProbe(StreamEndpoint Endpoint, ConnectionReason Reason, StreamSample Sample, string Sender = "");

// Found: the port with the stream that the reader wants, or else a port with another stream. HostAnswers: whether any port of the host answered.
// AdvancedBvh: the port with a stream that this library does not support.
internal readonly record struct PortScanResult(PortProbe? Found, bool HostAnswers, PortProbe? AdvancedBvh);

// Looks for the stream at other places: the usual data ports of the host and, for UDP, of this computer. It examines all of them at once, and no others.
internal static class AlternativePortScan
{
    public static async Task<PortScanResult> FindAsync(DiagnosisContext context, IPAddress? host, bool isUdp)
    {
        if (!context.Options.SearchOtherPorts)
            return default;

        using var shareSource = CancellationTokenSource.CreateLinkedTokenSource(context.CancellationToken);
        shareSource.CancelAfter(context.Share(context.Budget.OtherPorts));
        using var limitSource = CancellationTokenSource.CreateLinkedTokenSource(shareSource.Token);
        int[] tcpPorts = host is null ? [] : [.. PortsBeside(context, context.Options.UsualTcpPorts, skipped: !isUdp)];
        int[] udpPorts = [.. PortsBeside(context, context.Options.UsualUdpPorts, skipped: isUdp)];
        Task<PortProbe[]> tcp = Task.WhenAll(tcpPorts.Select(port => TryTcpAsync(context, host!, port, limitSource)));
        Task<PortProbe[]> udp = Task.WhenAll(udpPorts.Select(port => TryUdpAsync(context, port, limitSource)));
        PortProbe[] probes = [.. await tcp.ConfigureAwait(false), .. await udp.ConfigureAwait(false)];
        context.CancellationToken.ThrowIfCancellationRequested();

        PortProbe[] same = [.. probes.Where(probe => probe.Endpoint.Transport == TransportKind.Udp == isUdp)];
        PortProbe[] other = [.. probes.Except(same)];
        Report(context, same, "other ports");
        Report(context, other, isUdp ? "TCP" : "UDP");
        PortProbe[] ordered = [.. same, .. other];
        return new PortScanResult(
            ordered.FirstOrDefault(probe => probe.Sample.Has(context.Expected)) ?? ordered.FirstOrDefault(static probe => probe.Sample.Avatars.Any()),
            probes.Any(static probe =>
                probe.Endpoint.Transport == TransportKind.Tcp && probe.Reason is ConnectionReason.None or ConnectionReason.Refused),
            ordered.FirstOrDefault(static probe => probe.Sample.Guess().Format == ForeignFormat.AdvancedBvh));
    }

    // Starts with the port of the reader, which may carry the stream over the other transport. It is left out if it was already examined.
    private static IEnumerable<int> PortsBeside(DiagnosisContext context, int[] usual, bool skipped)
    {
        int own = context.Link.Port;
        IEnumerable<int> others = usual.Where(port => port != own);
        return skipped || own == 0 ? others : others.Prepend(own);
    }

    private static async Task<PortProbe> TryTcpAsync(DiagnosisContext context, IPAddress host, int port, CancellationTokenSource limitSource)
    {
        var sample = new StreamSample(context.Expected);
        var endpoint = new StreamEndpoint(TransportKind.Tcp, context.Link.Host, port);
        using var link = new TcpLink(context.Link with
        {
            Host = host.ToString(),
            Port = port,
            Tls = context.Link.Tls?.For(context.Link.Host),
            ConnectTimeout = context.Options.Timeout,
        });
        LinkEnd end = await link.OpenAsync(limitSource.Token).ConfigureAwait(false);
        if (end.Reason == ConnectionReason.None && !limitSource.IsCancellationRequested)
        {
            Task receiving = link.ReceiveAsync(sample, listener: null);
            await WaitForFrameAsync(context, sample, receiving, limitSource).ConfigureAwait(false);
            link.Close();
            await receiving.ConfigureAwait(false);
        }

        return new PortProbe(endpoint, end.Reason, sample);
    }

    private static async Task<PortProbe> TryUdpAsync(DiagnosisContext context, int port, CancellationTokenSource limitSource)
    {
        var sample = new StreamSample(context.Expected);
        var endpoint = new StreamEndpoint(TransportKind.Udp, context.Link.Host, port);

        // A shared port would take datagrams from the program that uses it.
        using var listener = new UdpListener(context.Link with { Port = port, SharePort = false }, new SenderFilter([]), sample);
        ConnectionReason reason = listener.Open();
        if (reason == ConnectionReason.None)
        {
            Task receiving = listener.ReceiveAsync();
            await WaitForFrameAsync(context, sample, receiving, limitSource).ConfigureAwait(false);
            listener.Dispose();
            await receiving.ConfigureAwait(false);
        }

        return new PortProbe(endpoint, reason, sample, listener.Senders.FirstOrDefault() ?? string.Empty);
    }

    // The first port with the wanted frames shortens the wait for the other ports.
    private static async Task WaitForFrameAsync(DiagnosisContext context, StreamSample sample, Task receiving, CancellationTokenSource limitSource)
    {
        await Task.WhenAny(sample.WantedFrame, receiving, Task.Delay(Timeout.Infinite, limitSource.Token)).ConfigureAwait(false);
        if (sample.WantedFrame.IsCompleted)
            limitSource.CancelAfter(context.Budget.Grace);
    }

    private static void Report(DiagnosisContext context, PortProbe[] probes, string name)
    {
        if (probes.Length == 0)
            return;

        List<string> found = [.. probes.Where(static probe => probe.Sample.Bytes > 0).Select(Describe)];
        string silent = Join(probes, static probe => probe.Reason == ConnectionReason.None && probe.Sample.Bytes == 0);
        string busy = Join(probes, static probe => probe.Reason == ConnectionReason.PortInUse);
        if (silent.Length > 0)
            found.Add($"nothing arrives on {silent}");
        if (busy.Length > 0)
            found.Add($"in use by another program: {busy}");
        if (found.Count == 0)
            found.Add($"nothing on {Join(probes, static _ => true)}");

        string detail = string.Join("; ", found);
        if (probes.Any(static probe => probe.Sample.Avatars.Any()))
            context.Log.Warning(name, detail);
        else
            context.Log.Ok(name, detail);
    }

    private static string Join(PortProbe[] probes, Func<PortProbe, bool> which) =>
        string.Join(", ", probes.Where(which).Select(static probe => probe.Endpoint.Port));

    private static string Describe(PortProbe probe)
    {
        string sender = probe.Sender.Length > 0 ? $" (from {probe.Sender})" : string.Empty;
        AvatarSample[] avatars = [.. probe.Sample.Avatars];
        return avatars.Length > 0
            ? $"{probe.Endpoint.Port} has {StreamPhrases.KindsOf(probe.Sample)}{sender}"
            : $"{probe.Endpoint.Port} has {probe.Sample.Guess().Text}{sender}";
    }
}
