using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// What a link has to know: a validated copy of the reader's options.
internal sealed record LinkOptions(string Host, int Port)
{
    // As people write it: an IPv6 address in brackets.
    public string Target => Host.Contains(':') && !Host.StartsWith('[') ? $"[{Host}]:{Port}" : $"{Host}:{Port}";

    public IPAddress? LocalAddress { get; init; }

    public TimeSpan ConnectTimeout { get; init; } = TimeSpan.FromSeconds(5);

    public int MaxValues { get; init; } = ProtocolConstants.DefaultMaxValues;

    public bool SharePort { get; init; }

    // Replaced by tests: what a resolver does on a machine without a network cannot be foreseen.
    public Func<string, Task<IPAddress[]>> Resolve { get; init; } = Dns.GetHostAddressesAsync;

    // How the connection waits; for each link one of its own.
    public Func<TcpReceiver> TakeReceiver { get; init; } = TcpReceivers.Shared.Take;
}
