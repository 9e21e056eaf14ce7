using System.Numerics;

namespace NeuronMocap.Bvh;

/// <summary>
/// Creates a <see cref="BvhHierarchy"/>, joint by joint in the order of a file. The order is depth first: each joint after its parent and
/// after all descendants of its earlier siblings. Not thread-safe.
/// </summary>
public sealed class BvhHierarchyBuilder
{
    private readonly List<BvhJoint> _joints = [];
    private readonly Stack<BvhJoint> _open = new();
    private int _channelCount;
    private bool _isBuilt;

    /// <summary>Adds a joint.</summary>
    /// <param name="name">The name. It must not contain line ends or braces, and must not begin or end with white space.</param>
    /// <param name="parent">The parent: the joint added last or one of its ancestors; null for a root.</param>
    /// <param name="offset">The position relative to the parent in the rest pose; Axis Neuron: centimetres.</param>
    /// <param name="channels">The channels in the order of the row; any number, including none.</param>
    /// <param name="endSite">The end of the bone, relative to the joint; null for none.</param>
    /// <returns>The joint, which can be the parent of others.</returns>
    /// <exception cref="ArgumentException">
    /// The name is not valid, the parent belongs to another builder or is already complete, or the format does not define a channel.
    /// </exception>
    /// <exception cref="InvalidOperationException">
    /// A limit for joints, channels or nesting depth is exceeded, or the hierarchy is already built.
    /// </exception>
    public BvhJoint Add(string name, BvhJoint? parent, Vector3 offset, ReadOnlySpan<BvhChannel> channels, Vector3? endSite = null)
    {
        ArgumentNullException.ThrowIfNull(name);
        if (_isBuilt)
            throw new InvalidOperationException("The hierarchy is already built.");
        if (_joints.Count == BvhDocument.MaxJoints)
            throw new InvalidOperationException($"The hierarchy must not have more than {BvhDocument.MaxJoints} joints.");
        if (name.AsSpan().IndexOfAny("{}\r\n") >= 0 || name.Trim().Length != name.Length || name.Length == 0)
            throw new ArgumentException("The name must not be empty, contain braces or line ends, or begin or end with white space.", nameof(name));

        foreach (BvhChannel channel in channels)
        {
            if (channel is not (>= BvhChannel.Xposition and <= BvhChannel.Zrotation))
                throw new ArgumentException($"{channel} is not a channel.", nameof(channels));
        }

        if (_channelCount + channels.Length > BvhDocument.MaxChannels)
            throw new InvalidOperationException($"The hierarchy must not have more than {BvhDocument.MaxChannels} channels.");

        CloseUpTo(parent);
        if (_open.Count == BvhDocument.MaxDepth)
            throw new InvalidOperationException($"Joints must not be nested more than {BvhDocument.MaxDepth} deep.");

        var joint = new BvhJoint(name, _joints.Count, parent) { Offset = offset, HasOffset = true, EndSite = endSite, FirstChannel = _channelCount };
        foreach (BvhChannel channel in channels)
            joint.AddChannel(channel);

        _channelCount += channels.Length;
        _joints.Add(joint);
        _open.Push(joint);
        return joint;
    }

    /// <summary>Completes the hierarchy.</summary>
    /// <returns>The hierarchy of all joints that were added.</returns>
    /// <exception cref="InvalidOperationException">No joint was added, or the hierarchy is already built.</exception>
    public BvhHierarchy Build()
    {
        if (_joints.Count == 0)
            throw new InvalidOperationException("The hierarchy needs at least one joint.");
        if (_isBuilt)
            throw new InvalidOperationException("The hierarchy is already built.");

        _isBuilt = true;
        return new BvhHierarchy(_joints, _channelCount);
    }

    private void CloseUpTo(BvhJoint? parent)
    {
        if (parent is not null && !_open.Contains(parent))
            throw new ArgumentException("The parent must be the previous joint or one of its ancestors.", nameof(parent));

        while (_open.Count > 0 && _open.Peek() != parent)
            _open.Pop();
    }
}
