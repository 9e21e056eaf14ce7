using System.Net;
using NeuronMocap.Diagnostics;

namespace NeuronMocap.Reader;

// Writes a program that receives a stream, for users to copy.
internal static class SampleProgram
{
    public static string For(NeuronReaderOptions options, StreamEndpoint endpoint, PacketKind wanted)
    {
        string method = wanted switch
        {
            PacketKind.Motion => nameof(NeuronReader.ReadMotionAsync),
            PacketKind.Calculation => nameof(NeuronReader.ReadCalculationAsync),
            _ => nameof(NeuronReader.ReadStudioCalculationAsync),
        };
        return $"""
            await using var reader = new NeuronReader({ArgumentsOf(options, endpoint)});
            await foreach (var frame in reader.{method}())
                Console.WriteLine(frame.AvatarName);
            """;
    }

    private static string ArgumentsOf(NeuronReaderOptions options, StreamEndpoint endpoint)
    {
        var parts = new List<string>();
        if (endpoint.Transport == TransportKind.Udp)
            parts.Add("Transport = TransportKind.Udp");
        else
            parts.Add($"Host = \"{endpoint.Host}\"");

        parts.Add($"Port = {endpoint.Port}");
        int essential = parts.Count;
        if (options.CalculationLink is { } calculation)
            parts.Add($"CalculationPort = {calculation.Port}");
        if (options.Tls is { } tls && endpoint.Transport == TransportKind.Tcp)
            parts.Add($"Tls = new NeuronTlsOptions{DescribeTls(tls)}");
        if (options.LocalAddress is { } address)
            parts.Add($"LocalAddress = {Parse(address)}");
        if (options.AllowedSenders.Count > 0 && endpoint.Transport == TransportKind.Udp)
            parts.Add($"AllowedSenders = [{string.Join(", ", options.AllowedSenders.Select(Parse))}]");
        if (options.SharePort && endpoint.Transport == TransportKind.Udp)
            parts.Add("SharePort = true");
        if (options.RotationOrder is { } order)
            parts.Add($"RotationOrder = RotationOrder.{order}");

        return endpoint.Transport == TransportKind.Tcp && parts.Count == essential
            ? $"\"{endpoint.Host}\", {endpoint.Port}"
            : $"new NeuronReaderOptions {{ {string.Join(", ", parts)} }}";
    }

    private static string DescribeTls(NeuronTlsOptions tls)
    {
        var parts = new List<string>();
        if (tls.TargetHost is { } name)
            parts.Add($"TargetHost = \"{name}\"");
        if (tls.TrustedCertificate is not null)
            parts.Add("TrustedCertificate = certificate /* the one that you trust */");

        return parts.Count > 0 ? $" {{ {string.Join(", ", parts)} }}" : "()";
    }

    private static string Parse(IPAddress address) => $"System.Net.IPAddress.Parse(\"{address}\")";
}
