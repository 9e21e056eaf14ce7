namespace NeuronMocap.Server.Broadcasting;

/// <summary>What a broadcast sends, as its recipients have to know it: frame after frame, each of whole packets.</summary>
internal abstract class BroadcastContent
{
    // Motion packets in a frame.
    public abstract int AvatarCount { get; }

    public abstract int PacketsPerFrame { get; }

    // Whether a calculation packet follows each motion packet.
    public abstract bool HasCalculation { get; }

    // Bytes of a frame, at most.
    public abstract int MaxFrameSize { get; }

    // The length of the motion or calculation packet that whole frames begin with.
    public abstract int MeasurePacket(ReadOnlySpan<byte> frames, bool isMotion);

    // All of it, from the start, for one recipient. Single: each read gives one frame.
    public abstract FrameFeed CreateFeed(bool isSingle);
}
