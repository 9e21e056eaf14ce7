namespace NeuronMocap.Skeleton;

/// <summary>Names and parents of the 59 bones (manual, Appendices A, B and D). Parents come before their children in <see cref="Bone"/> order.</summary>
public static class BoneHierarchy
{
    /// <summary>Number of bones.</summary>
    public const int BoneCount = 59;

    private const int None = -1;

    private static readonly Bone[] AllBones = [.. Enumerable.Range(0, BoneCount).Select(index => (Bone)index)];

    private static readonly string[] Neck1Names = Enum.GetNames(typeof(Bone));

    private static ReadOnlySpan<sbyte> Neck1Parents =>
    [
        None,
        0, 1, 2, // right leg
        0, 4, 5, // left leg
        0, 7, 8, 9, 10, 11, // spine, neck, head
        9, 13, 14, 15, // right arm
        16, 17, 18, 16, 20, 21, 22, 16, 24, 25, 26, 16, 28, 29, 30, 16, 32, 33, 34,
        9, 36, 37, 38, // left arm
        39, 40, 41, 39, 43, 44, 45, 39, 47, 48, 49, 39, 51, 52, 53, 39, 55, 56, 57,
    ];

    // The same except for the shoulders.
    private static ReadOnlySpan<sbyte> Spine3Parents =>
    [
        None,
        0, 1, 2,
        0, 4, 5,
        0, 7, 8, 9, 10, 11,
        10, 13, 14, 15,
        16, 17, 18, 16, 20, 21, 22, 16, 24, 25, 26, 16, 28, 29, 30, 16, 32, 33, 34,
        10, 36, 37, 38,
        39, 40, 41, 39, 43, 44, 45, 39, 47, 48, 49, 39, 51, 52, 53, 39, 55, 56, 57,
    ];

    /// <summary>All bones, in the order of the BVH stream.</summary>
    public static ReadOnlySpan<Bone> Bones => AllBones;

    /// <summary>Gets the parent of a bone.</summary>
    /// <param name="bone">The bone.</param>
    /// <param name="variant">Determines the parent of the shoulders.</param>
    /// <returns>The parent, or null for the hips.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static Bone? GetParent(Bone bone, SkeletonVariant variant = SkeletonVariant.Neck1)
    {
        int parent = ParentIndices(variant)[CheckedIndex(bone)];
        return parent == None ? null : (Bone)parent;
    }

    /// <summary>Gets the name of a bone in BVH files.</summary>
    /// <param name="bone">The bone.</param>
    /// <param name="variant">Determines the names at index 10 and 11.</param>
    /// <returns>The name, such as "RightInHandIndex".</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static string GetName(Bone bone, SkeletonVariant variant = SkeletonVariant.Neck1) => (variant, bone) switch
    {
        (SkeletonVariant.Spine3, Bone.Neck) => "Spine3",
        (SkeletonVariant.Spine3, Bone.Neck1) => "Neck",
        _ => Neck1Names[CheckedIndex(bone)],
    };

    /// <summary>Finds a bone by its name in a BVH file.</summary>
    /// <param name="name">The name, case-sensitive.</param>
    /// <param name="variant">Determines the names at index 10 and 11.</param>
    /// <param name="bone">Receives the bone if one has that name.</param>
    /// <returns>False if no bone has that name.</returns>
    public static bool TryFind(ReadOnlySpan<char> name, SkeletonVariant variant, out Bone bone)
    {
        foreach (Bone candidate in AllBones)
        {
            if (!name.SequenceEqual(GetName(candidate, variant).AsSpan()))
                continue;

            bone = candidate;
            return true;
        }

        bone = default;
        return false;
    }

    // The parent of every bone in their order. -1 for the hips.
    internal static ReadOnlySpan<sbyte> ParentIndices(SkeletonVariant variant) =>
        variant == SkeletonVariant.Spine3 ? Spine3Parents : Neck1Parents;

    internal static int CheckedIndex(Bone bone)
    {
        int index = (int)bone;
        if ((uint)index >= BoneCount)
            throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone must be one of the 59 bones, 0 to 58.");

        return index;
    }
}
