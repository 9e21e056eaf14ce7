using System.Numerics;

namespace NeuronMocap.Retargeting;

/// <summary>
/// A transform of a character at rest, relative to its parent, in Unity's axes. The rest pose is the T-pose of the avatar's HumanDescription, not the
/// character's current pose.
/// </summary>
/// <param name="Name">The name, used in messages and to find nodes.</param>
/// <param name="Parent">Index of the parent, lower than the node's own. -1 if the parent is the character's root, which is not a node itself.</param>
/// <param name="Position">The localPosition in metres, in the parent's axes and scale.</param>
/// <param name="Rotation">The localRotation.</param>
/// <param name="Scale">The localScale. Negative components mirror.</param>
public readonly record struct RigNode(string Name, int Parent, Vector3 Position, Quaternion Rotation, Vector3 Scale)
{
    /// <summary>Creates a node that is not scaled.</summary>
    /// <param name="name">The name.</param>
    /// <param name="parent">Index of the parent, or -1.</param>
    /// <param name="position">The localPosition, in metres.</param>
    /// <param name="rotation">The localRotation.</param>
    public RigNode(string name, int parent, Vector3 position, Quaternion rotation)
        : this(name, parent, position, rotation, Vector3.One)
    {
    }
}
