namespace NeuronMocap.Server.Broadcasting;

/// <summary>The content of a broadcast, as its recipients need to know it: a sequence of frames, each made of whole packets.</summary>
internal abstract class BroadcastContent
{
    public abstract int AvatarCount { get; }

    public abstract int PacketsPerFrame { get; }

    // Whether a frame holds a motion packet of each avatar.
    public abstract bool HasMotion { get; }

    // Whether a frame holds a calculation packet of each avatar. It follows the motion packet, if there is one.
    public abstract bool HasCalculation { get; }

    // Maximum size of a frame in bytes.
    public abstract int MaxFrameSize { get; }

    // Returns the length of the motion or calculation packet at the start of the frames.
    public abstract int MeasurePacket(ReadOnlySpan<byte> frames, bool isMotion);

    // Whether the packet with this index in its frame is a motion packet.
    public bool IsMotion(int place) => HasMotion && (!HasCalculation || place % 2 == 0);

    public int CountMotion(in FrameBatch batch) => !HasMotion
        ? 0
        : HasCalculation ? ((batch.First + batch.Packets + 1) / 2) - ((batch.First + 1) / 2) : batch.Packets;

    // Creates a feed of the whole content for one recipient. With isSingle, each read gives one frame.
    public abstract FrameFeed CreateFeed(bool isSingle);
}
