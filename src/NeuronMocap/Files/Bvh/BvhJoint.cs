using System.Numerics;

namespace NeuronMocap.Bvh;

/// <summary>One joint of a BVH file's hierarchy. Does not change once the document is read.</summary>
public sealed class BvhJoint
{
    private readonly List<BvhChannel> _channels = [];

    internal BvhJoint(string name, int index, BvhJoint? parent)
    {
        Name = name;
        Index = index;
        Parent = parent;
    }

    /// <summary>The name as it stands in the file, inner spaces included; empty where the file gives none. Need not be unique.</summary>
    public string Name { get; }

    /// <summary>Place in <see cref="BvhDocument.Joints"/>.</summary>
    public int Index { get; }

    /// <summary>The joint that this one hangs from; null for a root. A file may have several roots.</summary>
    public BvhJoint? Parent { get; }

    /// <summary>
    /// Position relative to the parent in the rest pose, in the file's unit of length (Axis Neuron: centimetres). Where the joint has
    /// position channels these replace it: in real takes the two differ by up to 1.3 cm.
    /// </summary>
    public Vector3 Offset { get; internal set; }

    /// <summary>
    /// The joint's values in the order of the row. Rotations are applied in this order: R(first) · R(second) · R(third) on column vectors.
    /// </summary>
    public IReadOnlyList<BvhChannel> Channels => _channels;

    /// <summary>Index of the joint's first value within a row; where there are no channels, of the value that would follow.</summary>
    public int FirstChannel { get; internal set; }

    /// <summary>Where the bone ends, relative to the joint, in the file's unit of length; null for a joint without an End Site.</summary>
    public Vector3? EndSite { get; internal set; }

    internal bool HasOffset { get; set; }

    internal void AddChannel(BvhChannel channel) => _channels.Add(channel);
}
