using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Options of a link: a validated copy of the reader's options.
internal sealed record LinkOptions(string Host, int Port)
{
    // The usual text form, with an IPv6 address in brackets.
    public string Target => Host.Contains(':') && !Host.StartsWith('[') ? $"[{Host}]:{Port}" : $"{Host}:{Port}";

    public IPAddress? LocalAddress { get; init; }

    public TimeSpan ConnectTimeout { get; init; } = TimeSpan.FromSeconds(5);

    // How long a stop waits for the disposal of a stream.
    public TimeSpan CloseTimeout { get; init; } = TimeSpan.FromSeconds(0.5);

    public int MaxValues { get; init; } = ProtocolConstants.DefaultMaxValues;

    public bool SharePort { get; init; }

    public ReceiveThread ReceiveThread { get; init; }

    // Null for a connection that is not encrypted.
    public NeuronTlsOptions? Tls { get; init; }

    // Tests replace it, because the behaviour of a resolver without a network is not predictable.
    public Func<string, Task<IPAddress[]>> Resolve { get; init; } = LookUpAsync;

    // How the connection waits; each link takes a new receiver.
    public Func<ReceiveThread, TcpReceiver> TakeReceiver { get; init; } = TcpReceivers.Shared.Take;

    // Resolves on its own thread. The asynchronous methods of the system use a pool thread on most systems, and a busy process may have none.
    private static async Task<IPAddress[]> LookUpAsync(string host)
    {
        IPAddress[] found = [];
        await DedicatedThread.RunAsync("NeuronMocap name", () => found = Dns.GetHostAddresses(host), TaskCreationOptions.None).ConfigureAwait(false);
        return found;
    }
}
