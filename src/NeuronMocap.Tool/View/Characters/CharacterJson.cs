using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>A character that a page shows from now on.</summary>
/// <param name="Name">The name of its file.</param>
/// <param name="Performer">The key of the performer that it follows; null for none.</param>
/// <param name="Variant">"Neck1" or "Spine3": how the performer's stream divides spine and neck. Null: "Neck1".</param>
/// <param name="Nodes">Its nodes at rest, parents first.</param>
/// <param name="Humanoid">The node of each bone by its name in VRM 1.0. Null: the names of the nodes tell.</param>
/// <param name="Lowest">The height of the figure's lowest point at rest, in metres. Null: the feet tell.</param>
/// <param name="Plant">Whether feet on the ground stay in their place. Null: yes.</param>
internal sealed record NewCharacterJson(
    string? Name, string? Performer, string? Variant, IReadOnlyList<NodeJson?>? Nodes, IReadOnlyDictionary<string, int>? Humanoid, float? Lowest, bool? Plant)
{
    /// <exception cref="ApiException">The nodes are missing, or a vector has another number of components.</exception>
    public IReadOnlyList<CharacterNode> ReadNodes() =>
        Nodes is null ? throw ApiException.BadRequest("The character has no nodes.") : [.. Nodes.Select(static node => (node ?? NodeJson.AtRest).Read())];
}

/// <summary>A node in glTF's axes, in metres. What is missing is at rest.</summary>
internal sealed record NodeJson(string? Name, int? Parent, float[]? Translation, float[]? Rotation, float[]? Scale)
{
    public static NodeJson AtRest { get; } = new(null, null, null, null, null);

    public CharacterNode Read() => new(
        Name ?? string.Empty,
        Parent ?? -1,
        Translation is null ? Vector3.Zero : ReadVector(Translation),
        Rotation is null ? Quaternion.Identity : ReadQuaternion(Rotation),
        Scale is null ? Vector3.One : ReadVector(Scale));

    private static Vector3 ReadVector(float[] values) => values is [var x, var y, var z]
        ? new Vector3(x, y, z)
        : throw ApiException.BadRequest("A position or a scale has three numbers.");

    private static Quaternion ReadQuaternion(float[] values) => values is [var x, var y, var z, var w]
        ? new Quaternion(x, y, z, w)
        : throw ApiException.BadRequest("A rotation has four numbers.");
}

/// <summary>What a page changes at a character. Null: as before.</summary>
/// <param name="Performer">The key of the performer that it follows.</param>
/// <param name="Variant">"Neck1" or "Spine3".</param>
/// <param name="Plant">Whether feet on the ground stay in their place.</param>
internal sealed record CharacterChangeJson(string? Performer, string? Variant, bool? Plant);

/// <summary>How to read the poses of a character.</summary>
/// <param name="Id">The number in its poses and in its addresses.</param>
/// <param name="Bones">The nodes that move, in the order of the rotations.</param>
/// <param name="HipsNode">The node whose position changes as well.</param>
/// <param name="Problems">A sentence for each fault that shows in the motion.</param>
internal sealed record CharacterJson(uint Id, IReadOnlyList<CharacterBoneJson> Bones, int HipsNode, IReadOnlyList<string> Problems)
{
    public static CharacterJson Of(uint id, CharacterRig rig, SkeletonVariant variant) => new(
        id,
        [
            .. rig.Bones.ToArray().Select(bone => new CharacterBoneJson(
                bone.Node, BoneHierarchy.GetName(bone.Source, variant), bone.Humanoid is { } humanoid ? VrmBoneNames.Of(humanoid) : null)),
        ],
        rig.HipsNode,
        rig.Problems);
}

/// <summary>A node that moves.</summary>
/// <param name="Node">Index of the node.</param>
/// <param name="Bone">The bone of the stream that it follows.</param>
/// <param name="Humanoid">Its name in VRM 1.0; null for the bones of the stream that a Humanoid lacks.</param>
internal sealed record CharacterBoneJson(int Node, string Bone, string? Humanoid);
