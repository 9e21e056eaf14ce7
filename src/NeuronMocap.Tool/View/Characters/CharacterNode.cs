using System.Numerics;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>A node of a character at rest, relative to its parent, in glTF's axes: right-handed, Y up, metres.</summary>
/// <param name="Name">The name in the file.</param>
/// <param name="Parent">Index of the parent, lower than the node's own, or -1.</param>
/// <param name="Translation">The position, in the parent's axes and scale.</param>
/// <param name="Rotation">The rotation, of any length except zero.</param>
/// <param name="Scale">The scale along the node's axes.</param>
internal readonly record struct CharacterNode(string Name, int Parent, Vector3 Translation, Quaternion Rotation, Vector3 Scale)
{
    /// <summary>Creates a node that is neither turned nor scaled.</summary>
    public CharacterNode(string name, int parent, Vector3 translation)
        : this(name, parent, translation, Quaternion.Identity, Vector3.One)
    {
    }
}
