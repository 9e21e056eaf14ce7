namespace NeuronMocap;

/// <summary>What a full queue does with the next frame.</summary>
public enum WhenFull
{
    /// <summary>The arriving frame is dropped and counted; waiting frames are kept.</summary>
    DropNewest,

    /// <summary>
    /// The frame that has waited longest is dropped and counted, and the arriving frame is added. A frame that a handler is using stays valid.
    /// </summary>
    DropOldest,

    /// <summary>
    /// The receive thread waits until there is room, or until the queue, its reader or the reader's recording player is disposed. All consumers of the
    /// reader wait with it.
    /// </summary>
    /// <remarks>
    /// Over TCP nothing is lost: when the buffers of both computers are full, the server waits, and may close the connection after a timeout. Over UDP the
    /// system drops datagrams when its receive buffer is full; <see cref="ReaderStatistics.Lost"/> counts them by their frame index.
    /// Do not pump such a queue on the receive thread: a handler there never runs while the thread waits.
    /// </remarks>
    Wait,
}
