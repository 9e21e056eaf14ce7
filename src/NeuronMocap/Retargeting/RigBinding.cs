using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>Which node of a rig is which bone of the stream, as <see cref="RigBinder"/> found it. Immutable; thread-safe.</summary>
public sealed class RigBinding
{
    private readonly int[] _nodes;

    internal RigBinding(int[] nodes, string prefix, IReadOnlyList<RigAmbiguity> ambiguities)
    {
        _nodes = nodes;
        Prefix = prefix;
        Ambiguities = ambiguities;
        Missing = [.. BoneHierarchy.Bones.ToArray().Where(bone => nodes[(int)bone] < 0)];
    }

    /// <summary>For each of the 59 bones, in their order, the index of its node, or -1: what <see cref="TargetRig.CreateGeneric"/> takes.</summary>
    public ReadOnlySpan<int> Nodes => _nodes;

    /// <summary>What the names begin with: as it was given, or as it was guessed from the name of the hips.</summary>
    public string Prefix { get; }

    /// <summary>How many bones were found.</summary>
    public int FoundCount => _nodes.Length - Missing.Count;

    /// <summary>The bones without a node, in their order. Palm bones and the upper neck are missing from most rigs, which does no harm.</summary>
    public IReadOnlyList<Bone> Missing { get; }

    /// <summary>The bones that several nodes were equally good for; the first of them was taken.</summary>
    public IReadOnlyList<RigAmbiguity> Ambiguities { get; }

    /// <summary>The node of a bone.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Index of the node, or -1.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public int GetNode(Bone bone) => _nodes[BoneHierarchy.CheckedIndex(bone)];
}

/// <summary>A bone that several nodes were equally good for.</summary>
/// <param name="Bone">The bone.</param>
/// <param name="Nodes">Indices of the nodes, two at least; the first was taken.</param>
public readonly record struct RigAmbiguity(Bone Bone, IReadOnlyList<int> Nodes);
