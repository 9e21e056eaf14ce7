namespace NeuronMocap.AspNetCore;

/// <summary>Counts what a <see cref="WebSocketBroadcaster"/> has sent since it was created. Totals include clients that have disconnected.</summary>
public readonly record struct WebSocketBroadcasterStatistics
{
    /// <summary>Clients that are connected.</summary>
    public int Clients { get; init; }

    /// <summary>Clients that were accepted.</summary>
    public long Accepted { get; init; }

    /// <summary>Requests that were refused, for any reason.</summary>
    public long Refused { get; init; }

    /// <summary>Frames that were sent, over all clients.</summary>
    public long FramesSent { get; init; }

    /// <summary>Frames that were dropped for clients that were too slow, over all clients.</summary>
    public long FramesDropped { get; init; }

    /// <summary>Frames that were left out because of the rates of clients, over all clients.</summary>
    public long FramesSkipped { get; init; }

    /// <summary>Frames that no client got, because this process was too busy to encode them.</summary>
    public long FramesMissed { get; init; }

    /// <summary>Bytes of the messages that were sent, without the headers of WebSockets.</summary>
    public long BytesSent { get; init; }

    internal WebSocketBroadcasterStatistics Add(in WebSocketClientStatistics client) => this with
    {
        FramesSent = FramesSent + client.FramesSent,
        FramesDropped = FramesDropped + client.FramesDropped,
        FramesSkipped = FramesSkipped + client.FramesSkipped,
        BytesSent = BytesSent + client.BytesSent,
    };
}
