using System.CommandLine;
using System.CommandLine.Parsing;
using System.Net;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The options for the connection to a server.</summary>
internal sealed class ConnectionArguments
{
    public Option<IPAddress[]> AllowSender { get; } = CommonOptions.Addresses(
        "--allow-sender",
        "With udp://: receive only from this address, and drop all other datagrams; may be repeated. Default: receive from all.");

    public Option<IPAddress?> LocalAddress { get; } = CommonOptions.Address(
        "--local-address",
        "On a computer with several networks: connect from this address, or receive UDP only on it. Default: TCP uses the address that the system chooses, UDP "
            + "all IPv4 addresses.");

    public Option<int?> CommandPort { get; } = CommonOptions.Port(
        "--command-port",
        "With a TCP source: ask the server's command channel on this port for the rotation order and the names of the bones, which most streams do not carry. "
            + $"Usually {ProtocolConstants.DefaultCommandPort}. The verb command shows all its answers.");

    public Option<int?> CalculationPort { get; } = CommonOptions.Port(
        "--calculation-port",
        "Receive calculation data as well, from this port of the server, over UDP on this port of this computer. "
            + $"Usually {ProtocolConstants.DefaultCalculationPort}.");

    public Option<X509Certificate2?> Trust { get; } = new("--trust")
    {
        HelpName = "FILE",
        Description = "With tls://: also trust the certificate in this file (PEM or DER). It is that of the server itself, or of the authority that has signed it.",
        CustomParser = LoadCertificate,
        Arity = ArgumentArity.ExactlyOne,
    };

    public Option<string?> TlsName { get; } = new("--tls-name")
    {
        HelpName = "NAME",
        Description = "With tls://: the name in the server's certificate, if it differs from HOST.",
        Arity = ArgumentArity.ExactlyOne,
    };

    public Option[] All => [AllowSender, LocalAddress, CommandPort, CalculationPort, Trust, TlsName];

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
        if (!source.IsEncrypted)
            Reject(result, Trust, "needs a source tls://HOST:PORT: no other source has a certificate to check.");
        if (!source.IsEncrypted)
            Reject(result, TlsName, "needs a source tls://HOST:PORT: no other source has a certificate to check.");
        if (source.IsEncrypted && result.GetResult(TlsName)?.Tokens is [{ Value: var name }] && string.IsNullOrWhiteSpace(name))
            result.AddError("--tls-name: the name is empty. Give the name in the server's certificate, or leave the option out.");
        if (source.LocalAddress is not null)
            Reject(result, LocalAddress, $"and {source} exclude each other: both say where to receive.");
    }

    /// <summary>Creates the options of a connection to the source.</summary>
    public ConnectionOptions Read(ParseResult result, Source source) => new()
    {
        Server = source.Server,
        WebSocket = source.WebSocket,
        Tls = source.IsEncrypted ? new NeuronTlsOptions { TrustedCertificate = result.GetValue(Trust), TargetHost = result.GetValue(TlsName) } : null,
        UdpPort = source.UdpPort,
        VmcPort = source.VmcPort,
        Broker = source.Broker,
        LocalAddress = result.GetValue(LocalAddress) ?? source.LocalAddress,
        AllowedSenders = result.GetValue(AllowSender) ?? [],
        CommandPort = result.GetValue(CommandPort),
        CalculationPort = result.GetValue(CalculationPort),
    };

    private static X509Certificate2? LoadCertificate(ArgumentResult result)
    {
        string file = result.Tokens[0].Value;
        try
        {
            return X509CertificateLoader.LoadCertificateFromFile(file);
        }
        catch (Exception exception) when (exception is CryptographicException or IOException or UnauthorizedAccessException)
        {
            result.AddError($"--trust: {(File.Exists(file) ? $"'{file}' is not a certificate in PEM or DER form." : $"there is no file '{file}'.")}");
            return null;
        }
    }

    private static void Reject(CommandResult result, Option option, string why)
    {
        if (Verb.IsGiven(result, option))
            result.AddError($"{option.Name} {why}");
    }
}
