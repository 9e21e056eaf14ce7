using System.Net;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server;

/// <summary>Counts what a <see cref="Broadcaster"/> has sent since its start. Totals include clients that have disconnected.</summary>
public readonly record struct BroadcasterStatistics
{
    internal BroadcasterStatistics(int clients, int calculationClients, long accepted, long refused, long incompletePackets, in RecipientCounters counters)
    {
        Clients = clients;
        CalculationClients = calculationClients;
        Accepted = accepted;
        Refused = refused;
        IncompletePackets = incompletePackets;
        FramesSent = counters.FramesSent;
        CalculationFramesSent = counters.CalculationFramesSent;
        PacketsDropped = counters.PacketsDropped;
        BytesSent = counters.BytesSent;
        RepliesSent = counters.RepliesSent;
        RequestsIgnored = counters.RequestsIgnored;
        RequestsDropped = counters.RequestsDropped;
    }

    /// <summary>
    /// TCP connections that are being served, on all ports. A client that connects to two ports counts twice. Readers of
    /// <see cref="Broadcaster.CreateLocalSource"/> are not counted here; <see cref="Broadcaster.GetClients"/> lists them.
    /// </summary>
    public int Clients { get; }

    /// <summary>TCP connections among <see cref="Clients"/> that are being served on <see cref="BroadcasterOptions.CalculationPort"/>.</summary>
    public int CalculationClients { get; }

    /// <summary>TCP connections that were served since the start, on all ports.</summary>
    public long Accepted { get; }

    /// <summary>
    /// TCP connections that were refused. Their port already had <see cref="BroadcasterOptions.MaxClients"/>, or the system had no resources left.
    /// </summary>
    public long Refused { get; }

    /// <summary>
    /// Motion packets, or lines of text, handed to the network or to readers in the same process. The total covers all avatars and all recipients.
    /// </summary>
    public long FramesSent { get; }

    /// <summary>
    /// Calculation packets, or lines of text, handed to the network or to readers in the same process. The total covers all avatars and all recipients.
    /// </summary>
    public long CalculationFramesSent { get; }

    /// <summary>Motion and calculation packets that were dropped before they reached the network or a reader in the same process.</summary>
    /// <remarks>
    /// A packet is dropped if a TCP client or a reader in the same process falls too far behind, or the system refuses a datagram. Packets
    /// that UDP loses on the way cannot be counted.
    /// </remarks>
    public long PacketsDropped { get; }

    /// <summary>
    /// Packets of which the <see cref="BroadcasterOptions.Reader"/> received only the start: its connection ended, or a datagram was lost. They are not sent.
    /// </summary>
    public long IncompletePackets { get; }

    /// <summary>Bytes handed to the network, including replies, or to readers in the same process.</summary>
    public long BytesSent { get; }

    /// <summary>Replies to commands on data connections, including values sent to clients that registered for them.</summary>
    public long RepliesSent { get; }

    /// <summary>
    /// Commands on data connections that have no answer: they have an undocumented number or name an avatar that does not exist.
    /// </summary>
    public long RequestsIgnored { get; }

    /// <summary>Commands on data connections that were dropped because 1024 commands of the same client were waiting.</summary>
    /// <remarks>
    /// With a <see cref="BroadcasterOptions.Reader"/>: commands of all clients that could not be passed to its server, because it was not connected or 1024
    /// commands were waiting. A registration that waits for a connection is not one of them.
    /// </remarks>
    public long RequestsDropped { get; }
}

/// <summary>
/// A recipient that a <see cref="Broadcaster"/> is serving: a TCP client, a UDP destination, or a reader in the same process.
/// </summary>
public readonly record struct BroadcasterClient
{
    internal BroadcasterClient(EndPoint? remoteEndPoint, bool isUdp, bool isCalculation, in RecipientCounters counters)
    {
        // A copy, because an end point can be changed.
        RemoteEndPoint = remoteEndPoint is IPEndPoint each ? new IPEndPoint(each.Address, each.Port) : remoteEndPoint;
        IsUdp = isUdp;
        IsCalculation = isCalculation;
        FramesSent = counters.FramesSent;
        CalculationFramesSent = counters.CalculationFramesSent;
        PacketsDropped = counters.PacketsDropped;
        BytesSent = counters.BytesSent;
        RepliesSent = counters.RepliesSent;
        RequestsIgnored = counters.RequestsIgnored;
        RequestsDropped = counters.RequestsDropped;
    }

    /// <summary>Address of the recipient; null for a reader of <see cref="Broadcaster.CreateLocalSource"/>.</summary>
    public EndPoint? RemoteEndPoint { get; }

    /// <summary>True for a UDP destination, false for other recipients.</summary>
    public bool IsUdp { get; }

    /// <summary>True for a recipient of <see cref="BroadcasterOptions.CalculationPort"/>, which receives calculation packets only.</summary>
    public bool IsCalculation { get; }

    /// <summary>Motion packets handed over for this recipient, of all avatars.</summary>
    public long FramesSent { get; }

    /// <summary>Calculation packets handed over for this recipient, of all avatars.</summary>
    public long CalculationFramesSent { get; }

    /// <summary>Motion and calculation packets that were dropped for this recipient.</summary>
    public long PacketsDropped { get; }

    /// <summary>Bytes handed over for this recipient, including replies.</summary>
    public long BytesSent { get; }

    /// <summary>Replies to this client's commands, including values sent because the client registered for them.</summary>
    public long RepliesSent { get; }

    /// <summary>Commands of this client that have no answer.</summary>
    public long RequestsIgnored { get; }

    /// <summary>Commands of this client that were dropped because 1024 of them were waiting.</summary>
    public long RequestsDropped { get; }
}
