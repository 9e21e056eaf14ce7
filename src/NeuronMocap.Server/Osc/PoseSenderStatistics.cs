namespace NeuronMocap.Server;

/// <summary>What a <see cref="PoseSender"/> has done so far.</summary>
public readonly record struct PoseSenderStatistics
{
    /// <summary>Number of frames of which every datagram was passed to the system. UDP does not tell whether they arrived.</summary>
    public long FramesSent { get; init; }

    /// <summary>
    /// Number of frames that were not sent, or not completely. A newer frame of the avatar was there already, or the network or the host
    /// name failed.
    /// </summary>
    public long FramesDropped { get; init; }

    /// <summary>Number of frames that cannot be sent, or that the options leave out: other avatars, no 59 bones, values that are not finite.</summary>
    public long FramesIgnored { get; init; }

    /// <summary>Number of frames that were left out because of <c>MaxRate</c>, of all avatars in the stream. No other figure includes them.</summary>
    public long FramesSkipped { get; init; }

    /// <summary>Number of datagrams that were passed to the system.</summary>
    public long DatagramsSent { get; init; }

    /// <summary>Number of datagrams that the system did not take.</summary>
    public long DatagramsFailed { get; init; }

    /// <summary>Number of bytes in the datagrams that were passed to the system.</summary>
    public long BytesSent { get; init; }

    /// <summary>
    /// How often the other computer said that no program listens on the port. Sending continues. Computers behind a firewall say nothing.
    /// </summary>
    public long Refusals { get; init; }

    /// <summary>Why nothing can be sent at present; null if it can. The sender tries again.</summary>
    public string? Failure { get; init; }
}
