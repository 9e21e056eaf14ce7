using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

/// <summary>Random poses and bodies, more extreme than those of any actor.</summary>
internal static class RandomPoses
{
    /// <summary>Any rotation.</summary>
    public static Quaternion Turn(Random random) => Quaternion.CreateFromYawPitchRoll(
        (random.NextSingle() - 0.5f) * 2 * MathF.PI, MathF.Asin((random.NextSingle() * 2) - 1), (random.NextSingle() - 0.5f) * 2 * MathF.PI);

    /// <summary>A rotation about any axis.</summary>
    public static Quaternion Turn(Random random, float mostDegrees) =>
        Quaternion.CreateFromAxisAngle(Direction(random), random.NextSingle() * mostDegrees * MathF.PI / 180);

    public static Vector3 Direction(Random random) => Vector3.Transform(Vector3.UnitX, Turn(random));

    /// <summary>
    /// A pose with every joint turned at random, the hips up to two metres from the origin, and bone positions as with displacement.
    /// </summary>
    public static BoneTransform[] Pose(Random random, float mostDegrees = 180)
    {
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int bone = 0; bone < pose.Length; bone++)
        {
            float reach = bone == 0 ? 200 : 30;
            Quaternion turn = Turn(random, bone == 0 ? 180 : mostDegrees);

            // Either of the two quaternions of the rotation.
            pose[bone] = new BoneTransform(Direction(random) * (random.NextSingle() * reach), random.Next(2) == 0 ? turn : Quaternion.Negate(turn));
        }

        return pose;
    }

    /// <summary>A body at rest with random sizes, and its hips at any position.</summary>
    public static SkeletonBody Body(Random random)
    {
        SkeletonVariant variant = random.Next(2) == 0 ? SkeletonVariant.Neck1 : SkeletonVariant.Spine3;
        Vector3[] offsets = [.. SkeletonBody.GetDefault(variant).Offsets.ToArray().Select(offset => offset * (0.6f + (random.NextSingle() * 0.8f)))];
        offsets[0] = new Vector3(0, random.NextSingle() * 100, 0);
        return new SkeletonBody(offsets, default, variant);
    }
}
