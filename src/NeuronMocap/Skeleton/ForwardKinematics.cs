namespace NeuronMocap.Skeleton;

/// <summary>From rotations relative to the parent to places in the world. Allocates nothing; thread-safe.</summary>
public static class ForwardKinematics
{
    /// <summary>Computes where every bone is.</summary>
    /// <param name="local">59 transforms relative to the parent, in <see cref="Bone"/> order.</param>
    /// <param name="world">Receives 59 transforms in the world; may be the same memory as <paramref name="local"/>.</param>
    /// <param name="variant">Decides where the shoulders hang.</param>
    /// <param name="root">What the hips are relative to: the Reference node, or null for the world itself.</param>
    /// <exception cref="ArgumentException">One of the spans is shorter than 59.</exception>
    public static void ToWorld(
        ReadOnlySpan<BoneTransform> local,
        Span<BoneTransform> world,
        SkeletonVariant variant = SkeletonVariant.Neck1,
        BoneTransform? root = null)
    {
        if (local.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There is a transform for each of the 59 bones.", nameof(local));
        if (world.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There is room for each of the 59 bones.", nameof(world));

        world[0] = root is { } reference ? reference.Apply(local[0]) : local[0];
        for (int bone = 1; bone < BoneHierarchy.BoneCount; bone++)
            world[bone] = world[BoneHierarchy.ParentIndex(bone, variant)].Apply(local[bone]);
    }
}
