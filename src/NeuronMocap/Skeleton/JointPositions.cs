using System.Numerics;

namespace NeuronMocap.Skeleton;

/// <summary>
/// The 72 points of a body: first the joints of the 59 bones in <see cref="Bone"/> order, then the ends of the 13 bones without children. Those are
/// feet, head and fingertips, in the order of <see cref="EndSiteBones"/>. Allocates nothing; thread-safe.
/// </summary>
public static class JointPositions
{
    /// <summary>Number of bones without children.</summary>
    public const int EndSiteCount = 13;

    /// <summary>Number of points: 72.</summary>
    public const int Count = BoneHierarchy.BoneCount + EndSiteCount;

    private static readonly Bone[] Ends = [.. BoneHierarchy.Bones.ToArray().Where(bone => DefaultOffsets.TryGetEndSite(bone, out _))];

    /// <summary>Gets the bones without children, in the order of their End Sites.</summary>
    public static ReadOnlySpan<Bone> EndSiteBones => Ends;

    /// <summary>Gets the index of the point at the end of a bone without children.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>59 to 71, or -1 for a bone that has children.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static int GetEndSiteIndex(Bone bone)
    {
        int index = Array.IndexOf(Ends, (Bone)BoneHierarchy.CheckedIndex(bone));
        return index < 0 ? -1 : BoneHierarchy.BoneCount + index;
    }

    /// <summary>Writes all points of a pose.</summary>
    /// <param name="world">59 transforms in the world.</param>
    /// <param name="body">Determines the ends of the bones.</param>
    /// <param name="positions">Receives 72 points, in the axes and units of <paramref name="world"/>.</param>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms, or there is no room for 72 points.</exception>
    public static void Copy(ReadOnlySpan<BoneTransform> world, SkeletonBody body, Span<Vector3> positions)
    {
        ArgumentNullException.ThrowIfNull(body);
        ForwardKinematics.CheckPose(world, nameof(world));
        if (positions.Length < Count)
            throw new ArgumentException("There must be room for 72 points.", nameof(positions));

        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
            positions[bone] = world[bone].Position;

        for (int i = 0; i < Ends.Length; i++)
            positions[BoneHierarchy.BoneCount + i] = GetEnd(world, body, Ends[i]);
    }

    /// <summary>Gets the lowest of all points. Its Y is the height of the ground under an actor who stands, sits or lies on it.</summary>
    /// <param name="world">59 transforms in the world.</param>
    /// <param name="body">Determines the ends of the bones.</param>
    /// <returns>The point with the lowest Y, in the axes and units of <paramref name="world"/>.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public static Vector3 GetLowest(ReadOnlySpan<BoneTransform> world, SkeletonBody body)
    {
        ArgumentNullException.ThrowIfNull(body);
        ForwardKinematics.CheckPose(world, nameof(world));
        Vector3 lowest = world[0].Position;
        for (int bone = 1; bone < BoneHierarchy.BoneCount; bone++)
            lowest = Lower(lowest, world[bone].Position);

        foreach (Bone bone in Ends)
            lowest = Lower(lowest, GetEnd(world, body, bone));

        return lowest;
    }

    internal static Vector3 GetEnd(ReadOnlySpan<BoneTransform> world, SkeletonBody body, Bone bone) =>
        world[(int)bone].TransformPoint(body.EndSites[(int)bone]);

    private static Vector3 Lower(Vector3 one, Vector3 other) => other.Y < one.Y ? other : one;
}
