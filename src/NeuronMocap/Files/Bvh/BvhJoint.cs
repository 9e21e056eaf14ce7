using System.Numerics;

namespace NeuronMocap.Bvh;

/// <summary>Represents one joint in the hierarchy of a BVH file. Immutable once the document is read.</summary>
public sealed class BvhJoint
{
    private readonly List<BvhChannel> _channels = [];

    internal BvhJoint(string name, int index, BvhJoint? parent)
    {
        Name = name;
        Index = index;
        Parent = parent;
    }

    /// <summary>The name as written in the file, including inner spaces; empty if the file has none. Names are not necessarily unique.</summary>
    public string Name { get; }

    /// <summary>Index in <see cref="BvhDocument.Joints"/>.</summary>
    public int Index { get; }

    /// <summary>The parent joint; null for a root. A file may have several roots.</summary>
    public BvhJoint? Parent { get; }

    /// <summary>
    /// Position relative to the parent in the rest pose, in the file's unit of length (Axis Neuron: centimetres). If the joint has position
    /// channels, their values replace this position. In real takes, the two differ by up to 1.3 cm.
    /// </summary>
    public Vector3 Offset { get; internal set; }

    /// <summary>
    /// The channels in the order of the row. Rotations are applied in this order: R(first) · R(second) · R(third) on column vectors.
    /// </summary>
    public IReadOnlyList<BvhChannel> Channels => _channels;

    /// <summary>Index of the joint's first value within a row. For a joint without channels, the index of the value that would follow.</summary>
    public int FirstChannel { get; internal set; }

    /// <summary>The end of the bone relative to the joint, in the file's unit of length; null for a joint without an End Site.</summary>
    public Vector3? EndSite { get; internal set; }

    internal bool HasOffset { get; set; }

    internal void AddChannel(BvhChannel channel) => _channels.Add(channel);
}
