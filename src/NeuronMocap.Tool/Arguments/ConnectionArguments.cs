using System.CommandLine;
using System.CommandLine.Parsing;
using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The options for the connection to a server.</summary>
internal sealed class ConnectionArguments
{
    public Option<IPAddress[]> AllowSender { get; } = CommonOptions.Addresses(
        "--allow-sender",
        "With udp://: let only this address send, and drop the datagrams of all others; may be repeated. Default: all may send.");

    public Option<IPAddress?> LocalAddress { get; } = CommonOptions.Address(
        "--local-address",
        "Of a computer with several networks: connect from this address of it, or receive UDP on it only. Default: over TCP as the system chooses, over UDP "
            + "all IPv4 addresses.");

    public Option<int?> CommandPort { get; } = CommonOptions.Port(
        "--command-port",
        "With a TCP source: ask the server's command channel on this port for the rotation order and the names of the bones, which most streams do not say. "
            + $"Usually {ProtocolConstants.DefaultCommandPort}; the verb command shows all that it tells.");

    public Option<int?> CalculationPort { get; } = CommonOptions.Port(
        "--calculation-port",
        "Receive calculation data as well, from this port of the server, over UDP on this port of this computer. "
            + $"Usually {ProtocolConstants.DefaultCalculationPort}.");

    public Option[] All => [AllowSender, LocalAddress, CommandPort, CalculationPort];

    /// <summary>Adds an error for every option that has no meaning for the source.</summary>
    public void RejectContradictions(CommandResult result, Source source)
    {
        bool isConnected = source.Kind is SourceKind.Tcp or SourceKind.Udp;
        if (source.Kind != SourceKind.Udp)
            Reject(result, AllowSender, "needs a source udp://:PORT: over TCP the data comes from the server that the source names.");
        if (source.Kind != SourceKind.Tcp)
            Reject(result, CommandPort, "needs a source HOST or tcp://HOST:PORT: it is another port of that server.");
        if (!isConnected)
            Reject(result, LocalAddress, "needs a server or udp://:PORT as the source: it is the end of that connection on this computer.");
        if (!isConnected)
            Reject(result, CalculationPort, "needs a server or udp://:PORT as the source: it is another port of the same server.");
        if (source.LocalAddress is not null)
            Reject(result, LocalAddress, $"and {source} exclude each other: both say where to receive.");
    }

    private static void Reject(CommandResult result, Option option, string why)
    {
        if (Verb.IsGiven(result, option))
            result.AddError($"{option.Name} {why}");
    }
}
