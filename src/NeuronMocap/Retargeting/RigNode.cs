using System.Numerics;

namespace NeuronMocap.Retargeting;

/// <summary>
/// One transform of a character at rest, relative to its parent, in Unity's axes. At rest means in T-pose: the pose of the avatar's
/// HumanDescription, not whatever the character is doing.
/// </summary>
/// <param name="Name">For messages, and for finding nodes.</param>
/// <param name="Parent">Index of the parent, lower than the node's own; -1 when that is the character's root, which is no node itself.</param>
/// <param name="Position">localPosition: metres, in the parent's axes and scale.</param>
/// <param name="Rotation">localRotation.</param>
/// <param name="Scale">localScale; negative components mirror.</param>
public readonly record struct RigNode(string Name, int Parent, Vector3 Position, Quaternion Rotation, Vector3 Scale)
{
    /// <summary>A node that is not scaled.</summary>
    /// <param name="name">For messages.</param>
    /// <param name="parent">Index of the parent, or -1.</param>
    /// <param name="position">localPosition, metres.</param>
    /// <param name="rotation">localRotation.</param>
    public RigNode(string name, int parent, Vector3 position, Quaternion rotation)
        : this(name, parent, position, rotation, Vector3.One)
    {
    }
}
