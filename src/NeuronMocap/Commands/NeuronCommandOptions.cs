using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Commands;

/// <summary>
/// What a <see cref="NeuronCommandClient"/> has to know. The client takes a copy when it is made; later changes have no effect on it.
/// </summary>
public sealed class NeuronCommandOptions
{
    /// <summary>
    /// Name or address of the computer that runs Axis Neuron; this computer unless set. A name with several addresses is tried address by address.
    /// </summary>
    public string Host { get; set; } = "127.0.0.1";

    /// <summary>
    /// TCP port of the server's command channel, 1 to 65535; not the one of its stream. 8013 unless set: see
    /// <see cref="ProtocolConstants.DefaultCommandPort"/>.
    /// </summary>
    public int Port { get; set; } = ProtocolConstants.DefaultCommandPort;

    /// <summary>Longest time to wait for the name, and for each of its addresses to answer. 5 s unless set; more than zero, at most 5 minutes.</summary>
    public TimeSpan ConnectTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Longest time from the sending of a request to the last byte of its reply. What a call waits for before, its turn after others and a
    /// connection, does not count. 3 s unless set, as in the vendor's library; 1 ms to 5 minutes.
    /// </summary>
    public TimeSpan Timeout { get; set; } = TimeSpan.FromSeconds(3);

    /// <summary>
    /// Largest payload of a reply in bytes, 48 to 200,016. 100,000 unless set: the vendor's MAX_PACKETSIZE. A reply that announces more is refused
    /// before anything is kept of it.
    /// </summary>
    public int MaxReplySize { get; set; } = ProtocolConstants.MaxCommandPayload;

    /// <summary>
    /// Takes the first reply for the answer, whatever command's number it carries, as the vendor's library does. Off unless set: then only a reply
    /// that carries the number of the request, or 0, is the answer. Set it for a server that puts something else there.
    /// </summary>
    public bool AcceptAnyReplyId { get; set; }

    /// <summary>Makes options for an address as people write it; everything but <see cref="Host"/> and <see cref="Port"/> keeps its default.</summary>
    /// <param name="address">
    /// <c>HOST</c> or <c>HOST:PORT</c>, port 8013 unless given. An IPv6 address with a port stands in brackets: <c>[::1]:8013</c>.
    /// </param>
    /// <returns>New options.</returns>
    /// <exception cref="FormatException">The text is not an address; the message says why, in words for the person who wrote it.</exception>
    public static NeuronCommandOptions Parse(string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        (string host, int port) = AddressText.ParseServer(address, ProtocolConstants.DefaultCommandPort);
        return new NeuronCommandOptions { Host = host, Port = port };
    }

    internal LinkOptions Link => new(Host, Port) { ConnectTimeout = ConnectTimeout };

    internal NeuronCommandOptions Copy() => (NeuronCommandOptions)MemberwiseClone();

    internal string? FindFault()
    {
        if (string.IsNullOrWhiteSpace(Host))
            return "Host is empty; give the name or address of the computer that runs Axis Neuron.";
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
