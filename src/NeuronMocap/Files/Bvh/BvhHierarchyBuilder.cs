using System.Numerics;

namespace NeuronMocap.Bvh;

/// <summary>
/// Makes a <see cref="BvhHierarchy"/>, joint by joint in the order of a file: depth first, each joint after its parent and after all that
/// hangs from the siblings before it. For one thread.
/// </summary>
public sealed class BvhHierarchyBuilder
{
    private readonly List<BvhJoint> _joints = [];
    private readonly Stack<BvhJoint> _open = new();
    private int _channelCount;
    private bool _isBuilt;

    /// <summary>Adds a joint.</summary>
    /// <param name="name">Its name; without line ends, braces, and white space around it.</param>
    /// <param name="parent">What it hangs from: the joint added last, or one that that one hangs from; null for a root.</param>
    /// <param name="offset">Position relative to the parent in the rest pose; Axis Neuron: centimetres.</param>
    /// <param name="channels">Its values in the order of the row; none, one, or as many as wanted.</param>
    /// <param name="endSite">Where the bone ends, relative to the joint; null for none.</param>
    /// <returns>The joint, to be named as a parent.</returns>
    /// <exception cref="ArgumentException">
    /// The name cannot stand in a file, the parent is another builder's, what hangs from it is complete, or a channel is none that the format has.
    /// </exception>
    /// <exception cref="InvalidOperationException">There would be too many joints or channels, or joints nested too deep; or the hierarchy is built.</exception>
    public BvhJoint Add(string name, BvhJoint? parent, Vector3 offset, ReadOnlySpan<BvhChannel> channels, Vector3? endSite = null)
    {
        ArgumentNullException.ThrowIfNull(name);
        if (_isBuilt)
            throw new InvalidOperationException("The hierarchy is built already.");
        if (_joints.Count == BvhDocument.MaxJoints)
            throw new InvalidOperationException($"There are {BvhDocument.MaxJoints} joints already.");
        if (name.AsSpan().IndexOfAny("{}\r\n") >= 0 || name.Trim().Length != name.Length || name.Length == 0)
            throw new ArgumentException("The name must not be empty, and must not have braces, line ends, or white space around it.", nameof(name));

        foreach (BvhChannel channel in channels)
        {
            if (channel is not (>= BvhChannel.Xposition and <= BvhChannel.Zrotation))
                throw new ArgumentException($"{channel} is not a channel.", nameof(channels));
        }

        if (_channelCount + channels.Length > BvhDocument.MaxChannels)
            throw new InvalidOperationException($"The hierarchy must not have more than {BvhDocument.MaxChannels} channels.");

        CloseUpTo(parent);
        if (_open.Count == BvhDocument.MaxDepth)
            throw new InvalidOperationException($"Joints are nested {BvhDocument.MaxDepth} deep already.");

        var joint = new BvhJoint(name, _joints.Count, parent) { Offset = offset, HasOffset = true, EndSite = endSite, FirstChannel = _channelCount };
        foreach (BvhChannel channel in channels)
            joint.AddChannel(channel);

        _channelCount += channels.Length;
        _joints.Add(joint);
        _open.Push(joint);
        return joint;
    }

    /// <summary>Ends the building.</summary>
    /// <returns>The hierarchy of all joints that were added.</returns>
    /// <exception cref="InvalidOperationException">There is no joint, or the hierarchy is built already.</exception>
    public BvhHierarchy Build()
    {
        if (_joints.Count == 0)
            throw new InvalidOperationException("The hierarchy needs at least one joint.");
        if (_isBuilt)
            throw new InvalidOperationException("The hierarchy is built already.");

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
