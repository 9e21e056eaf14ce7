using System.Net;

namespace NeuronMocap.AspNetCore;

/// <summary>A client of a <see cref="WebSocketBroadcaster"/>, with its counters.</summary>
public readonly record struct WebSocketClientStatistics
{
    /// <summary>Address of the client; null if the server does not know it.</summary>
    public EndPoint? RemoteEndPoint { get; init; }

    /// <summary>The form of its messages.</summary>
    public WebSocketForm Form { get; init; }

    /// <summary>Largest number of frames per second of each avatar; 0 for no limit.</summary>
    public double MaxRate { get; init; }

    /// <summary>Frames that were sent.</summary>
    public long FramesSent { get; init; }

    /// <summary>Frames that were dropped for newer ones because the client was too slow, and those that were left at its end.</summary>
    public long FramesDropped { get; init; }

    /// <summary>Frames that were left out because of the rate.</summary>
    public long FramesSkipped { get; init; }

    /// <summary>Bytes of the messages that were sent, without the headers of WebSockets.</summary>
    public long BytesSent { get; init; }
}
