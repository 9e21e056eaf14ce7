namespace NeuronMocap.RabbitMq;

/// <summary>The counts of a source since it was created, over all its connections.</summary>
public sealed record RabbitMqSourceStatistics
{
    /// <summary>Packets that the reader gets.</summary>
    public long Packets { get; init; }

    /// <summary>Bytes of these packets.</summary>
    public long Bytes { get; init; }

    /// <summary>
    /// Frames between the first and the last received frame of each avatar that are missing, also those of the time without a connection. The publisher
    /// numbers its frames; a number that is left out is a lost frame. What happened while the publisher itself was not running is not counted.
    /// </summary>
    public long Lost { get; init; }

    /// <summary>
    /// Frames that arrived a second time and were left out. A publisher sends unconfirmed frames again after a failure. A source receives some frames
    /// again if the broker has lost the end of the stream.
    /// </summary>
    public long Duplicates { get; init; }

    /// <summary>Messages that were left out because they are not one packet with a frame.</summary>
    public long Invalid { get; init; }

    /// <summary>
    /// Messages of a stream that were left out because they belong to another stage, avatar or kind, or to a time before the start.
    /// </summary>
    public long Skipped { get; init; }

    /// <summary>Number of the last message in the stream; null for live frames, and before the first message.</summary>
    public long? LastOffset { get; init; }

    /// <summary>Connections that were made.</summary>
    public int Connections { get; init; }
}
