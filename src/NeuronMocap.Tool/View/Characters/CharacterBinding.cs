using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>Which nodes are bones: as the file says, or by their names.</summary>
/// <param name="IsHumanoid">Whether the indices are those of the 55 Humanoid bones. Otherwise, they are those of the 59 bones of the stream.</param>
/// <param name="Nodes">The index of the node for each bone, or -1.</param>
internal sealed record CharacterBinding(bool IsHumanoid, int[] Nodes)
{
    // Fewer of the fifteen bones that every Humanoid has are a coincidence of names.
    private const int LeastBones = 5;

    /// <summary>Binds the nodes of a character.</summary>
    /// <param name="nodes">The nodes, parents first.</param>
    /// <param name="humanoid">The node of each bone by its name in VRM 1.0. Null: the names of the nodes tell.</param>
    /// <param name="variant">How the performer's stream divides spine and neck.</param>
    /// <param name="problems">Receives a sentence for what is missing.</param>
    /// <exception cref="CharacterException">The character has too few bones, or the map is wrong.</exception>
    public static CharacterBinding Create(
        IReadOnlyList<CharacterNode> nodes, IReadOnlyDictionary<string, int>? humanoid, SkeletonVariant variant, ICollection<string> problems)
    {
        CharacterBinding binding = humanoid is null ? ByName(nodes, variant) : ByMap(nodes.Count, humanoid);
        HumanoidBone[] required = [.. Enumerable.Range(0, HumanoidBones.Count).Select(static bone => (HumanoidBone)bone).Where(HumanoidBones.IsRequired)];
        string[] missing = [.. required.Where(bone => binding.NodeOf(bone) < 0).Select(VrmBoneNames.InWords)];
        if (binding.Nodes[0] < 0 || required.Length - missing.Length < LeastBones)
            throw new CharacterException(missing.Length == required.Length
                ? "none of its nodes has the name of a bone, such as Hips, Spine or LeftArm."
                : $"it lacks these bones: {string.Join(", ", missing)}.");
        if (missing.Length > 0)
            problems.Add($"The character lacks these bones, and moves without them: {string.Join(", ", missing)}.");

        return binding;
    }

    // A rig that follows the stream may lack its first spine bones: the others take their place.
    private int NodeOf(HumanoidBone bone)
    {
        if (IsHumanoid)
            return Nodes[(int)bone];
        if (bone == HumanoidBone.Spine)
            return Nodes[(int)Bone.Spine..((int)Bone.Spine2 + 1)].Max();

        return HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is { } source ? Nodes[(int)source] : -1;
    }

    private static CharacterBinding ByName(IReadOnlyList<CharacterNode> nodes, SkeletonVariant variant)
    {
        string[] names = [.. nodes.Select(static node => node.Name)];
        RigBinding found = RigBinder.Bind(names, variant: variant, parents: [.. nodes.Select(static node => node.Parent)]);
        return new CharacterBinding(IsHumanoid: false, found.Nodes.ToArray());
    }

    private static CharacterBinding ByMap(int count, IReadOnlyDictionary<string, int> humanoid)
    {
        int[] map = [.. Enumerable.Repeat(-1, HumanoidBones.Count)];
        foreach ((string name, int node) in humanoid)
        {
            if (node < 0 || node >= count)
                throw new CharacterException($"the humanoid bone {name} refers to node {node}, which does not exist.");
            if (VrmBoneNames.TryFind(name, out HumanoidBone bone))
                map[(int)bone] = node;
        }

        return new CharacterBinding(IsHumanoid: true, map);
    }
}
