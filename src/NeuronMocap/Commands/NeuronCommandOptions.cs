using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Commands;

/// <summary>Options of a <see cref="NeuronCommandClient"/>. The client copies them when it is made; later changes have no effect on it.</summary>
public sealed class NeuronCommandOptions
{
    /// <summary>
    /// Name or address of the computer that runs Axis Neuron. The default is this computer. If a name has several addresses, the client tries them one
    /// after another.
    /// </summary>
    public string Host { get; set; } = "127.0.0.1";

    /// <summary>
    /// TCP port of the server's command channel, 1 to 65535; it differs from the port of the stream. The default is 8013: see
    /// <see cref="ProtocolConstants.DefaultCommandPort"/>.
    /// </summary>
    public int Port { get; set; } = ProtocolConstants.DefaultCommandPort;

    /// <summary>
    /// Address of this computer to connect from. With null, the default, the system chooses. Set it if the computer has several networks.
    /// </summary>
    public IPAddress? LocalAddress { get; set; }

    /// <summary>
    /// Longest time to wait for the name to resolve, and for each of its addresses to answer: more than zero, at most 5 minutes. The default is 5 s.
    /// </summary>
    public TimeSpan ConnectTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Longest time from the start of sending a request to the last byte of its reply: 1 ms to 5 minutes. The default is 3 s, as in the vendor's library.
    /// The time in which a call waits for its turn and for a connection does not count.
    /// </summary>
    public TimeSpan Timeout { get; set; } = TimeSpan.FromSeconds(3);

    /// <summary>
    /// Largest payload of a reply in bytes, 48 to 200,016. The default is 100,000, the vendor's MAX_PACKETSIZE. The client rejects a reply that announces
    /// more before it stores any of it.
    /// </summary>
    public int MaxReplySize { get; set; } = ProtocolConstants.MaxCommandPayload;

    /// <summary>
    /// Accepts the first reply as the answer, whatever command number it has, as the vendor's library does. The default is off: the reply must have the
    /// number of the request, or 0. Set it for a server that sends another number.
    /// </summary>
    public bool AcceptAnyReplyId { get; set; }

    /// <summary>
    /// Creates options from an address in the form used on command lines. It sets <see cref="Host"/> and <see cref="Port"/>; all other options keep their
    /// defaults.
    /// </summary>
    /// <param name="address">
    /// <c>HOST</c> or <c>HOST:PORT</c>; the default port is 8013. An IPv6 address with a port needs brackets: <c>[::1]:8013</c>.
    /// </param>
    /// <returns>New options.</returns>
    /// <exception cref="FormatException">The text is not an address; the message says why.</exception>
    public static NeuronCommandOptions Parse(string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        (string host, int port) = AddressText.ParseServer(address, ProtocolConstants.DefaultCommandPort);
        return new NeuronCommandOptions { Host = host, Port = port };
    }

    internal LinkOptions Link => new(Host, Port) { ConnectTimeout = ConnectTimeout, LocalAddress = LocalAddress };

    internal NeuronCommandOptions Copy() => (NeuronCommandOptions)MemberwiseClone();

    internal string? FindFault()
    {
        if (string.IsNullOrWhiteSpace(Host))
            return "Host is empty; give the name or address of the computer that runs Axis Neuron.";
        if (AddressText.HasPort(Host))
            return $"Host is {Host}; it must be a name or address alone. Set Port, or make the options with NeuronCommandOptions.Parse.";
        if (Port is < 1 or > IPEndPoint.MaxPort)
            return $"Port is {Port}; it must be 1 to {IPEndPoint.MaxPort}.";
        if (ConnectTimeout <= TimeSpan.Zero || ConnectTimeout > TimeSpan.FromMinutes(5))
            return $"ConnectTimeout is {ConnectTimeout}; it must be more than zero and at most 5 minutes.";
        if (Timeout < TimeSpan.FromMilliseconds(1) || Timeout > TimeSpan.FromMinutes(5))
            return $"Timeout is {Timeout}; it must be 1 ms to 5 minutes.";
        if (MaxReplySize is < Skeleton.BoneDimensions.Size or > ProtocolConstants.MaxCommandReply)
            return $"MaxReplySize is {MaxReplySize}; it must be {Skeleton.BoneDimensions.Size} to {ProtocolConstants.MaxCommandReply}.";

        return null;
    }
}
