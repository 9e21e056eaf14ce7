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

    public ReceiveThread ReceiveThread { get; init; }

    // Replaced by tests: what a resolver does on a machine without a network cannot be foreseen.
    public Func<string, Task<IPAddress[]>> Resolve { get; init; } = LookUpAsync;

    // How the connection waits; for each link one of its own.
    public Func<ReceiveThread, TcpReceiver> TakeReceiver { get; init; } = TcpReceivers.Shared.Take;

    // On a thread of its own: what the system offers without one takes a pool thread on most systems, and in a busy process there may be none.
    private static async Task<IPAddress[]> LookUpAsync(string host)
    {
        IPAddress[] found = [];
        await DedicatedThread.RunAsync("NeuronMocap name", () => found = Dns.GetHostAddresses(host), TaskCreationOptions.None).ConfigureAwait(false);
        return found;
    }
}
