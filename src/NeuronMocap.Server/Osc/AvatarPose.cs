using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Osc;

/// <summary>The newest pose of an avatar. One thread uses it.</summary>
internal sealed class AvatarPose(int sender, int index)
{
    public int Sender => sender;

    public int Index => index;

    public string Name { get; private set; } = string.Empty;

    public SkeletonVariant Variant { get; private set; }

    public uint? FrameIndex { get; private set; }

    /// <summary>Time of receipt, in ticks of the stopwatch.</summary>
    public long Timestamp { get; private set; }

    /// <summary>Transforms relative to the parent; the hips include the Reference node.</summary>
    public BoneTransform[] Local { get; } = new BoneTransform[BoneHierarchy.BoneCount];

    /// <summary>Whether the pose has not been sent.</summary>
    public bool IsPending { get; set; }

    /// <summary>What an encoder keeps for the avatar.</summary>
    public object? Cache { get; set; }

    public void Take(MotionFrame frame)
    {
        // The strings of names are cached.
        if (!ReferenceEquals(Name, frame.AvatarName))
            (Name, Cache) = (frame.AvatarName, null);

        Variant = frame.Format.Variant;
        FrameIndex = frame.FrameIndex;
        Timestamp = frame.Timestamp;
        frame.CopyLocalTransforms(Local);
        if (frame.Layout.HasReference)
            Local[0] = frame.GetReference().Apply(Local[0]);

        IsPending = true;
    }
}
