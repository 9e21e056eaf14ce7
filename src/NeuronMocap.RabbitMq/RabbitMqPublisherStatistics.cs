namespace NeuronMocap.RabbitMq;

/// <summary>The counts of a publisher since it was created.</summary>
/// <remarks>
/// <see cref="Frames"/> is <see cref="Dropped"/> + <see cref="Waiting"/> + the frames that were handed to the connection. Without a stream, frames can also
/// be lost on their way to the broker. Sources count them.
/// </remarks>
public sealed record RabbitMqPublisherStatistics
{
    /// <summary>Frames that the reader has received.</summary>
    public long Frames { get; init; }

    /// <summary>Messages that were handed to the connection, with repetitions.</summary>
    public long Published { get; init; }

    /// <summary>Frames that the broker has confirmed; 0 without a stream.</summary>
    public long Confirmed { get; init; }

    /// <summary>Frames that were sent again, because the connection failed before their confirmation.</summary>
    public long Repeated { get; init; }

    /// <summary>
    /// Frames that were never sent: there was no connection, or the broker was too slow for <see cref="RabbitMqPublisherOptions.Capacity"/>.
    /// </summary>
    public long Dropped { get; init; }

    /// <summary>Frames that wait for the broker.</summary>
    public int Waiting { get; init; }

    /// <summary>Frames that were sent and wait for their confirmation.</summary>
    public int Unconfirmed { get; init; }

    /// <summary>Bytes of the packets in <see cref="Published"/>.</summary>
    public long Bytes { get; init; }

    /// <summary>Connections that were made.</summary>
    public int Connections { get; init; }
}
