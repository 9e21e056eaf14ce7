namespace NeuronMocap.Bvh;

/// <summary>
/// Represents the joints of a BVH file and the values that each joint has in a row. It is created by <see cref="BvhHierarchyBuilder"/> or read from
/// a file. Immutable; thread-safe.
/// </summary>
public sealed class BvhHierarchy
{
    internal BvhHierarchy(IReadOnlyList<BvhJoint> joints, int channelCount)
    {
        Joints = joints;
        ChannelCount = channelCount;
    }

    /// <summary>The joints in the order of the file, depth first, parents before their children. There is at least one.</summary>
    public IReadOnlyList<BvhJoint> Joints { get; }

    /// <summary>Number of values in a row.</summary>
    public int ChannelCount { get; }
}
