using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>Maps the nodes of a rig to the bones of the stream, as found by <see cref="RigBinder"/>. Immutable and thread-safe.</summary>
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

    /// <summary>
    /// Gets the index of the node for each of the 59 bones in their order, or -1. Pass it to <see cref="TargetRig.CreateGeneric"/>.
    /// </summary>
    public ReadOnlySpan<int> Nodes => _nodes;

    /// <summary>Gets the text that the names begin with, as given or as guessed from the name of the hips.</summary>
    public string Prefix { get; }

    /// <summary>Gets the number of bones that were found.</summary>
    public int FoundCount => _nodes.Length - Missing.Count;

    /// <summary>Gets the bones without a node, in their order. Most rigs lack palm bones and the upper neck, which does no harm.</summary>
    public IReadOnlyList<Bone> Missing { get; }

    /// <summary>Gets the bones that matched several nodes equally well. The first of the nodes was taken.</summary>
    public IReadOnlyList<RigAmbiguity> Ambiguities { get; }

    /// <summary>Gets the node of a bone.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>Index of the node, or -1.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public int GetNode(Bone bone) => _nodes[BoneHierarchy.CheckedIndex(bone)];
}

/// <summary>A bone that matched several nodes equally well.</summary>
/// <param name="Bone">The bone.</param>
/// <param name="Nodes">Indices of at least two nodes. The first was taken.</param>
public readonly record struct RigAmbiguity(Bone Bone, IReadOnlyList<int> Nodes);
