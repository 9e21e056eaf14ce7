namespace NeuronMocap.Server.Broadcasting;

/// <summary>Supplies the bytes of one recipient: whole packets in order, from the recipient's own position.</summary>
internal abstract class FrameFeed
{
    /// <summary>Whether frames appear in real time. If so, available packets must be sent without waiting for more.</summary>
    public abstract bool IsLive { get; }

    /// <summary>Whether the recipient has received the last frame.</summary>
    public abstract bool IsAtEnd { get; }

    /// <summary>Whether no more packets will follow: the last frame was given, or the broadcast was stopped.</summary>
    public virtual bool HasEnded => IsAtEnd;

    /// <summary>Packets that the recipient missed because it was too slow. Thread-safe.</summary>
    public abstract long MissedPackets { get; }

    /// <summary>Waits for packets and writes as many as fit.</summary>
    /// <param name="destination">Room for at least one frame.</param>
    /// <returns>The packets that were written. Empty after <see cref="Wake"/>, and when no more packets will follow.</returns>
    public abstract FrameBatch Read(Span<byte> destination);

    /// <summary>Lets the feed hand units to the recipient on another thread while <see cref="Read"/> waits. Called before the first read.</summary>
    /// <param name="recipient">The recipient.</param>
    public virtual void Attach(IDirectRecipient recipient)
    {
    }

    /// <summary>Releases the data that the feed reads from. Called after the last read.</summary>
    public virtual void Close()
    {
    }

    /// <summary>Ends the current wait of <see cref="Read"/>, or else its next wait. Thread-safe.</summary>
    public virtual void Wake()
    {
    }
}
