namespace NeuronMocap.Skeleton;

/// <summary>Converts transforms relative to the parent to transforms in the world, and back. Allocates nothing; thread-safe.</summary>
public static class ForwardKinematics
{
    /// <summary>Computes the world transforms of all bones.</summary>
    /// <param name="local">59 transforms relative to the parent, in <see cref="Bone"/> order.</param>
    /// <param name="world">Receives 59 transforms in the world. May be the same memory as <paramref name="local"/>.</param>
    /// <param name="variant">Determines the parent of the shoulders.</param>
    /// <param name="root">The parent of the hips: the Reference node, or null for the world itself.</param>
    /// <exception cref="ArgumentException">One of the spans is shorter than 59.</exception>
    public static void ToWorld(
        ReadOnlySpan<BoneTransform> local,
        Span<BoneTransform> world,
        SkeletonVariant variant = SkeletonVariant.Neck1,
        BoneTransform? root = null)
    {
        CheckPose(local, nameof(local));
        CheckRoom(world, nameof(world));

        ReadOnlySpan<sbyte> parents = BoneHierarchy.ParentIndices(variant);
        world[0] = root is { } reference ? reference.Apply(local[0]) : local[0];
        for (int bone = 1; bone < BoneHierarchy.BoneCount; bone++)
            world[bone] = world[parents[bone]].Apply(local[bone]);
    }

    /// <summary>Computes transforms relative to the parent from world transforms. It is the inverse of <see cref="ToWorld"/>.</summary>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order.</param>
    /// <param name="local">Receives 59 transforms relative to the parent. May be the same memory as <paramref name="world"/>.</param>
    /// <param name="variant">Determines the parent of the shoulders.</param>
    /// <param name="root">The parent of the hips: the Reference node, or null for the world itself.</param>
    /// <exception cref="ArgumentException">One of the spans is shorter than 59.</exception>
    public static void ToLocal(
        ReadOnlySpan<BoneTransform> world,
        Span<BoneTransform> local,
        SkeletonVariant variant = SkeletonVariant.Neck1,
        BoneTransform? root = null)
    {
        CheckPose(world, nameof(world));
        CheckRoom(local, nameof(local));

        ReadOnlySpan<sbyte> parents = BoneHierarchy.ParentIndices(variant);

        // Children come first. If source and result share memory, the parent of a child is still a world transform.
        for (int bone = BoneHierarchy.BoneCount - 1; bone > 0; bone--)
            local[bone] = world[parents[bone]].ToLocal(world[bone]);

        local[0] = root is { } reference ? reference.ToLocal(world[0]) : world[0];
    }

    internal static void CheckPose(ReadOnlySpan<BoneTransform> pose, string name)
    {
        if (pose.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There must be a transform for each of the 59 bones.", name);
    }

    internal static void CheckRoom(Span<BoneTransform> pose, string name)
    {
        if (pose.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There must be room for each of the 59 bones.", name);
    }
}
