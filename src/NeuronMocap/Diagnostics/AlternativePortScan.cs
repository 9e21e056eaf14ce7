using System.Net;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// What another port had.
internal sealed record Probe(StreamPlace Place, ConnectionReason Reason, StreamSample Sample, string Sender = "");

// Found: the port with the stream that the reader wants, else with another one. HostAnswers: whether any of the host's ports did. AdvancedBvh: the
// port with a stream that is not read.
internal readonly record struct Search(Probe? Found, bool HostAnswers, Probe? AdvancedBvh);

// Where the stream might be instead: the usual data ports of the host, and of this computer for UDP. All at once, and only those.
internal static class AlternativePortScan
{
    public static async Task<Search> FindAsync(DiagnosisContext task, IPAddress? host, bool isUdp)
    {
        if (!task.Options.SearchOtherPorts)
            return default;

        using var share = CancellationTokenSource.CreateLinkedTokenSource(task.Stop);
        share.CancelAfter(task.Share(task.Pace.Elsewhere));
        using var limit = CancellationTokenSource.CreateLinkedTokenSource(share.Token);
        int[] tcpPorts = host is null ? [] : [.. PortsBeside(task, task.Options.UsualTcpPorts, skipped: !isUdp)];
        int[] udpPorts = [.. PortsBeside(task, task.Options.UsualUdpPorts, skipped: isUdp)];
        Task<Probe[]> tcp = Task.WhenAll(tcpPorts.Select(port => TryTcpAsync(task, host!, port, limit)));
        Task<Probe[]> udp = Task.WhenAll(udpPorts.Select(port => TryUdpAsync(task, port, limit)));
        Probe[] probes = [.. await tcp.ConfigureAwait(false), .. await udp.ConfigureAwait(false)];
        task.Stop.ThrowIfCancellationRequested();

        Probe[] same = [.. probes.Where(probe => probe.Place.Transport == TransportKind.Udp == isUdp)];
        Probe[] other = [.. probes.Except(same)];
        Tell(task, same, "other ports");
        Tell(task, other, isUdp ? "TCP" : "UDP");
        Probe[] ordered = [.. same, .. other];
        return new Search(
            ordered.FirstOrDefault(probe => probe.Sample.Has(task.Expected)) ?? ordered.FirstOrDefault(static probe => probe.Sample.Avatars.Any()),
            probes.Any(static probe =>
                probe.Place.Transport == TransportKind.Tcp && probe.Reason is ConnectionReason.None or ConnectionReason.Refused),
            ordered.FirstOrDefault(static probe => probe.Sample.Guess().Format == ForeignFormat.AdvancedBvh));
    }

    // The port of the reader first, which may carry the stream over the other transport; it is left out where it was looked at already.
    private static IEnumerable<int> PortsBeside(DiagnosisContext task, int[] usual, bool skipped)
    {
        int own = task.Link.Port;
        IEnumerable<int> others = usual.Where(port => port != own);
        return skipped || own == 0 ? others : others.Prepend(own);
    }

    private static async Task<Probe> TryTcpAsync(DiagnosisContext task, IPAddress host, int port, CancellationTokenSource limit)
    {
        var sample = new StreamSample(task.Expected);
        var place = new StreamPlace(TransportKind.Tcp, task.Link.Host, port);
        using var link = new TcpLink(task.Link with { Host = host.ToString(), Port = port, ConnectTimeout = task.Options.Timeout });
        LinkEnd end = await link.OpenAsync(limit.Token).ConfigureAwait(false);
        if (end.Reason == ConnectionReason.None && !limit.IsCancellationRequested)
        {
            Task receiving = link.ReceiveAsync(sample, listener: null);
            await WaitForFrameAsync(task, sample, receiving, limit).ConfigureAwait(false);
            link.Close();
            await receiving.ConfigureAwait(false);
        }

        return new Probe(place, end.Reason, sample);
    }

    private static async Task<Probe> TryUdpAsync(DiagnosisContext task, int port, CancellationTokenSource limit)
    {
        var sample = new StreamSample(task.Expected);
        var place = new StreamPlace(TransportKind.Udp, task.Link.Host, port);

        // A shared port would take the datagrams away from the program that uses it.
        using var listener = new UdpListener(task.Link with { Port = port, SharePort = false }, new SenderFilter([]), sample);
        ConnectionReason reason = listener.Open();
        if (reason == ConnectionReason.None)
        {
            Task receiving = listener.ReceiveAsync();
            await WaitForFrameAsync(task, sample, receiving, limit).ConfigureAwait(false);
            listener.Dispose();
            await receiving.ConfigureAwait(false);
        }

        return new Probe(place, reason, sample, listener.Senders.FirstOrDefault() ?? string.Empty);
    }

    // The first port that has what is wanted cuts the wait for the others short.
    private static async Task WaitForFrameAsync(DiagnosisContext task, StreamSample sample, Task receiving, CancellationTokenSource limit)
    {
        await Task.WhenAny(sample.WantedFrame, receiving, Task.Delay(Timeout.Infinite, limit.Token)).ConfigureAwait(false);
        if (sample.WantedFrame.IsCompleted)
            limit.CancelAfter(task.Pace.Grace);
    }

    private static void Tell(DiagnosisContext task, Probe[] probes, string name)
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
            task.Log.Warning(name, detail);
        else
            task.Log.Ok(name, detail);
    }

    private static string Join(Probe[] probes, Func<Probe, bool> which) =>
        string.Join(", ", probes.Where(which).Select(static probe => probe.Place.Port));

    private static string Describe(Probe probe)
    {
        string sender = probe.Sender.Length > 0 ? $" (from {probe.Sender})" : string.Empty;
        AvatarSample[] avatars = [.. probe.Sample.Avatars];
        return avatars.Length > 0
            ? $"{probe.Place.Port} has {StreamPhrases.KindsOf(probe.Sample)}{sender}"
            : $"{probe.Place.Port} has {probe.Sample.Guess().Text}{sender}";
    }
}
