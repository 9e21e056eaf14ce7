namespace NeuronMocap.Bvh;

/// <summary>
/// The joints of a BVH file and the values that each of them has in a row. Made by <see cref="BvhHierarchyBuilder"/>, or read from a file.
/// Immutable; thread-safe.
/// </summary>
public sealed class BvhHierarchy
{
    internal BvhHierarchy(IReadOnlyList<BvhJoint> joints, int channelCount)
    {
        Joints = joints;
        ChannelCount = channelCount;
    }

    /// <summary>The joints, parents before their children, depth first as in the file; at least one.</summary>
    public IReadOnlyList<BvhJoint> Joints { get; }

    /// <summary>Number of values in a row.</summary>
    public int ChannelCount { get; }
}
