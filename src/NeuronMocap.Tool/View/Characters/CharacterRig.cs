using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>
/// A character ready to be driven: its skeleton and the nodes that move. The skeleton has the axes of <see cref="TargetRig"/> and a T-pose
/// that faces +Z above the origin. Immutable and thread-safe.
/// </summary>
internal sealed class CharacterRig
{
    /// <summary>The most nodes that a character may have.</summary>
    public const int MaxNodes = 4096;

    private readonly CharacterBone[] _bones;

    private CharacterRig(TargetRig target, IReadOnlyList<string> problems)
    {
        Target = target;
        Problems = problems;
        HumanoidBoneSet present = target.Bones;
        List<CharacterBone> bones = [];
        for (int node = 0; node < target.Nodes.Length; node++)
        {
            HumanoidBone? humanoid = HumanoidAt(target, node);
            Bone? source = target.IsHumanoid
                ? humanoid is { } bone ? HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, present) : null
                : target.GetBone(node);
            if (source is { } followed)
                bones.Add(new CharacterBone(node, followed, humanoid));
        }

        _bones = [.. bones];
    }

    /// <summary>Gets the skeleton, in Unity's axes. Its nodes have the indices of the given nodes.</summary>
    public TargetRig Target { get; }

    /// <summary>Gets the nodes that move. Poses contain them in this order.</summary>
    public ReadOnlySpan<CharacterBone> Bones => _bones;

    /// <summary>Gets the node that changes its position as well.</summary>
    public int HipsNode => Target.HipsNode;

    /// <summary>Gets a sentence for each fault that shows in the motion.</summary>
    public IReadOnlyList<string> Problems { get; }

    /// <summary>Creates a character.</summary>
    /// <param name="nodes">Its nodes at rest, parents first.</param>
    /// <param name="humanoid">The node of each bone by its name in VRM 1.0. Null: the names of the nodes tell.</param>
    /// <param name="lowest">The height of the figure's lowest point at rest, in metres. Null: the feet tell.</param>
    /// <param name="variant">How the performer's stream divides spine and neck.</param>
    /// <exception cref="CharacterException">The character cannot be driven.</exception>
    public static CharacterRig Create(
        IReadOnlyList<CharacterNode> nodes,
        IReadOnlyDictionary<string, int>? humanoid = null,
        float? lowest = null,
        SkeletonVariant variant = SkeletonVariant.Neck1)
    {
        Check(nodes);
        List<string> problems = [];
        CharacterBinding binding = CharacterBinding.Create(nodes, humanoid, variant, problems);
        RigNode[] mirrored = [.. nodes.Select(GltfAxes.ToRig)];
        try
        {
            TargetRig given = Build(mirrored, binding);
            bool isUpright = IsUpright(given);
            if (RigValidator.Validate(given).FirstOrDefault(static issue => issue.Fault == RigFault.SidesSwapped) is { } swapped)
                problems.Add(swapped.Message);

            TargetRig straight = TPose.Enforce(given);
            return new CharacterRig(Stand(straight, binding, isUpright ? lowest : null), problems);
        }
        catch (ArgumentException fault)
        {
            throw new CharacterException(char.ToLowerInvariant(fault.Message[0]) + fault.Message[1..].Split(" (Parameter")[0]);
        }
    }

    private static HumanoidBone? HumanoidAt(TargetRig target, int node)
    {
        for (int bone = 0; bone < HumanoidBones.Count; bone++)
        {
            if (target.GetNode((HumanoidBone)bone) == node)
                return (HumanoidBone)bone;
        }

        return null;
    }

    private static void Check(IReadOnlyList<CharacterNode> nodes)
    {
        if (nodes.Count is 0 or > MaxNodes)
            throw new CharacterException($"it has {nodes.Count} nodes, and a character has 1 to {MaxNodes}.");

        for (int i = 0; i < nodes.Count; i++)
        {
            if (nodes[i].Parent < -1 || nodes[i].Parent >= i)
                throw new CharacterException($"node {i} comes before its parent.");
        }
    }

    private static TargetRig Build(RigNode[] nodes, CharacterBinding binding) => binding.IsHumanoid
        ? TargetRig.CreateHumanoid(nodes, binding.Nodes)
        : TargetRig.CreateGeneric(nodes, binding.Nodes);

    private static bool IsUpright(TargetRig rig)
    {
        if (rig.GetNode(HumanoidBone.Head) is not (>= 0 and var head))
            return true;

        Vector3 way = rig.RestPositions[head] - rig.RestPositions[rig.HipsNode];
        return way.Y > 0.9f * way.Length();
    }

    // Moves the hips above the origin, and the soles to the ground. A file may keep its figure anywhere.
    private static TargetRig Stand(TargetRig rig, CharacterBinding binding, float? lowest)
    {
        float rise = -lowest ?? RiseOfAnkles(rig);
        Vector3 hips = rig.RestPositions[rig.HipsNode];
        RigNode[] nodes = rig.Nodes.ToArray();
        nodes[rig.HipsNode] = nodes[rig.HipsNode] with { Position = rig.ToHipsParent(new Vector3(0, hips.Y + rise, 0)) };
        return Build(nodes, binding);
    }

    // How far to raise a figure whose ankles have no usual height.
    private static float RiseOfAnkles(TargetRig rig)
    {
        float height = float.PositiveInfinity;
        foreach (HumanoidBone foot in (ReadOnlySpan<HumanoidBone>)[HumanoidBone.LeftFoot, HumanoidBone.RightFoot])
        {
            if (rig.GetNode(foot) is >= 0 and var node)
                height = Math.Min(height, rig.RestPositions[node].Y);
        }

        float leg = rig.LegLength;
        return !float.IsFinite(height) || leg == 0 || (height >= 0 && height <= 0.25f * leg) ? 0 : (0.1f * leg) - height;
    }
}
