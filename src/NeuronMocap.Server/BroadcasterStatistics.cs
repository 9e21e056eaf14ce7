using System.Net;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server;

/// <summary>What a <see cref="Broadcaster"/> has done so far. Totals include clients that have left.</summary>
public readonly record struct BroadcasterStatistics
{
    internal BroadcasterStatistics(int clients, int calculationClients, long accepted, long refused, in RecipientCounters counters)
    {
        Clients = clients;
        CalculationClients = calculationClients;
        Accepted = accepted;
        Refused = refused;
        FramesSent = counters.FramesSent;
        CalculationFramesSent = counters.CalculationFramesSent;
        PacketsDropped = counters.PacketsDropped;
        BytesSent = counters.BytesSent;
        RepliesSent = counters.RepliesSent;
        RequestsIgnored = counters.RequestsIgnored;
        RequestsDropped = counters.RequestsDropped;
    }

    /// <summary>TCP connections that are served now, on all ports: a client that connects to two ports counts twice.</summary>
    public int Clients { get; }

    /// <summary>TCP connections among <see cref="Clients"/> that are served on <see cref="BroadcasterOptions.CalculationPort"/>.</summary>
    public int CalculationClients { get; }

    /// <summary>TCP connections that were served since the start, on all ports.</summary>
    public long Accepted { get; }

    /// <summary>
    /// TCP connections that were turned away: their port had <see cref="BroadcasterOptions.MaxClients"/>, or the system had no room for one more.
    /// </summary>
    public long Refused { get; }

    /// <summary>Motion packets, or lines of text, handed to the network, of all avatars and to all receivers together.</summary>
    public long FramesSent { get; }

    /// <summary>Calculation packets, or lines of text, handed to the network, of all avatars and to all receivers together.</summary>
    public long CalculationFramesSent { get; }

    /// <summary>
    /// Motion and calculation packets that receivers did not get: because a TCP client fell too far behind, or because the system refused
    /// a datagram. What UDP loses on its way nobody can count.
    /// </summary>
    public long PacketsDropped { get; }

    /// <summary>Bytes handed to the network, those of replies among them.</summary>
    public long BytesSent { get; }

    /// <summary>Replies to commands on data connections, and values sent because somebody registered for them.</summary>
    public long RepliesSent { get; }

    /// <summary>
    /// Commands on data connections that have no answer: numbers that nobody has documented, and avatars that there are not.
    /// </summary>
    public long RequestsIgnored { get; }

    /// <summary>Commands on data connections that were dropped because 1024 of the same client were waiting.</summary>
    public long RequestsDropped { get; }
}

/// <summary>One receiver of a <see cref="Broadcaster"/> that is served now: a TCP client or a UDP destination.</summary>
public readonly record struct BroadcasterClient
{
    internal BroadcasterClient(EndPoint? remoteEndPoint, bool isUdp, bool isCalculation, in RecipientCounters counters)
    {
        RemoteEndPoint = remoteEndPoint;
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

    /// <summary>The receiver's address, where the system tells it.</summary>
    public EndPoint? RemoteEndPoint { get; }

    /// <summary>True for a UDP destination, false for a TCP client.</summary>
    public bool IsUdp { get; }

    /// <summary>True for a receiver of <see cref="BroadcasterOptions.CalculationPort"/>, which gets calculation packets alone.</summary>
    public bool IsCalculation { get; }

    /// <summary>Motion packets handed to the network for this receiver, of all avatars together.</summary>
    public long FramesSent { get; }

    /// <summary>Calculation packets handed to the network for this receiver, of all avatars together.</summary>
    public long CalculationFramesSent { get; }

    /// <summary>Motion and calculation packets that this receiver did not get.</summary>
    public long PacketsDropped { get; }

    /// <summary>Bytes handed to the network for this receiver, those of replies among them.</summary>
    public long BytesSent { get; }

    /// <summary>Replies to this client's commands, and values sent because it registered for them.</summary>
    public long RepliesSent { get; }

    /// <summary>This client's commands that have no answer.</summary>
    public long RequestsIgnored { get; }

    /// <summary>This client's commands that were dropped because 1024 of them were waiting.</summary>
    public long RequestsDropped { get; }
}
