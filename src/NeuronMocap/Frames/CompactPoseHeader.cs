using NeuronMocap.Skeleton;

namespace NeuronMocap;

/// <summary>What a compact pose says besides position and rotations: whose pose it is, and when. See <see cref="CompactPose"/>.</summary>
public readonly record struct CompactPoseHeader
{
    /// <summary>Number of the avatar on the server, as <see cref="AvatarFrame.AvatarIndex"/>.</summary>
    public int AvatarIndex { get; init; }

    /// <summary>Name of the avatar, 32 bytes of UTF-8 at most. It ends at its first zero byte.</summary>
    public AvatarName AvatarName { get; init; }

    /// <summary>The server's frame counter; null if there is none.</summary>
    public uint? FrameIndex { get; init; }

    /// <summary>When the frame was received, on the clock of the computer that encoded it. Encoding rounds it down to whole microseconds.</summary>
    public DateTimeOffset Time { get; init; }

    /// <summary>Determines the parent of the shoulders, and the names of two bones.</summary>
    public SkeletonVariant Variant { get; init; }
}
