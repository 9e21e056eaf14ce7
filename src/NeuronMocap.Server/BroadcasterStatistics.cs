using System.Net;

namespace NeuronMocap.Server;

/// <summary>What a <see cref="Broadcaster"/> has done so far. Totals include clients that have left.</summary>
public readonly record struct BroadcasterStatistics
{
    internal BroadcasterStatistics(int clients, long accepted, long refused, long framesSent, long packetsDropped, long bytesSent)
    {
        Clients = clients;
        Accepted = accepted;
        Refused = refused;
        FramesSent = framesSent;
        PacketsDropped = packetsDropped;
        BytesSent = bytesSent;
    }

    /// <summary>TCP clients that are connected now.</summary>
    public int Clients { get; }

    /// <summary>TCP clients that were served since the start.</summary>
    public long Accepted { get; }

    /// <summary>TCP clients that were turned away because there were <see cref="BroadcasterOptions.MaxClients"/>.</summary>
    public long Refused { get; }

    /// <summary>Motion packets handed to the network, of all avatars and to all receivers together.</summary>
    public long FramesSent { get; }

    /// <summary>
    /// Motion and calculation packets that receivers did not get: because a TCP client fell too far behind, or because the system refused
    /// a datagram. What UDP loses on its way nobody can count.
    /// </summary>
    public long PacketsDropped { get; }

    /// <summary>Bytes handed to the network.</summary>
    public long BytesSent { get; }
}

/// <summary>One receiver of a <see cref="Broadcaster"/> that is served now: a TCP client or a UDP destination.</summary>
public readonly record struct BroadcasterClient
{
    internal BroadcasterClient(EndPoint? remoteEndPoint, bool isUdp, long framesSent, long packetsDropped, long bytesSent)
    {
        RemoteEndPoint = remoteEndPoint;
        IsUdp = isUdp;
        FramesSent = framesSent;
        PacketsDropped = packetsDropped;
        BytesSent = bytesSent;
    }

    /// <summary>The receiver's address, where the system tells it.</summary>
    public EndPoint? RemoteEndPoint { get; }

    /// <summary>True for a UDP destination, false for a TCP client.</summary>
    public bool IsUdp { get; }

    /// <summary>Motion packets handed to the network for this receiver, of all avatars together.</summary>
    public long FramesSent { get; }

    /// <summary>Motion and calculation packets that this receiver did not get.</summary>
    public long PacketsDropped { get; }

    /// <summary>Bytes handed to the network for this receiver.</summary>
    public long BytesSent { get; }
}
