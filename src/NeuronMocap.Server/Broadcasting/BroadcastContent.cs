namespace NeuronMocap.Server.Broadcasting;

/// <summary>What a broadcast sends, as its recipients have to know it: frame after frame, each of whole packets.</summary>
internal abstract class BroadcastContent
{
    public abstract int AvatarCount { get; }

    public abstract int PacketsPerFrame { get; }

    // Whether frames hold a motion packet of each avatar.
    public abstract bool HasMotion { get; }

    // Whether frames hold a calculation packet of each avatar, which follows the motion packet where there is one.
    public abstract bool HasCalculation { get; }

    // Bytes of a frame, at most.
    public abstract int MaxFrameSize { get; }

    // The length of the motion or calculation packet that whole frames begin with.
    public abstract int MeasurePacket(ReadOnlySpan<byte> frames, bool isMotion);

    // Whether the packet with this place in its frame is a motion packet.
    public bool IsMotion(int place) => HasMotion && (!HasCalculation || place % 2 == 0);

    public int CountMotion(in FrameBatch batch) => !HasMotion
        ? 0
        : HasCalculation ? ((batch.First + batch.Packets + 1) / 2) - ((batch.First + 1) / 2) : batch.Packets;

    // All of it, from the start, for one recipient. Single: each read gives one frame.
    public abstract FrameFeed CreateFeed(bool isSingle);
}
