namespace NeuronMocap.Server.Broadcasting;

/// <summary>Where the bytes of one recipient come from: whole packets in order, with the recipient's own position.</summary>
internal abstract class FrameFeed
{
    /// <summary>Whether frames appear as time goes by, so that what is there must be sent without waiting for more.</summary>
    public abstract bool IsLive { get; }

    /// <summary>Whether the recipient has been given the last frame.</summary>
    public abstract bool IsAtEnd { get; }

    /// <summary>Whether there will be no more: the last frame was given, or the broadcast was stopped.</summary>
    public virtual bool HasEnded => IsAtEnd;

    /// <summary>Packets that the recipient was too slow for. Safe to read on any thread.</summary>
    public abstract long MissedPackets { get; }

    /// <summary>Waits for packets and writes as many as fit.</summary>
    /// <param name="destination">Room for at least one frame.</param>
    /// <returns>What was written; nothing after <see cref="Wake"/>, and when there will be no more.</returns>
    public abstract FrameBatch Read(Span<byte> destination);

    /// <summary>Lets go of what it reads from. Called when nobody reads any more.</summary>
    public virtual void Close()
    {
    }

    /// <summary>Ends the wait of <see cref="Read"/>, this one or else the next. Safe on any thread.</summary>
    public virtual void Wake()
    {
    }
}
