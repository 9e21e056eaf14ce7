using System.Numerics;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Info;

/// <summary>The twelve sizes of a body, for each side separately.</summary>
/// <param name="Mean">The mean sizes of both sides.</param>
/// <param name="Left">The sizes of a body with two left sides.</param>
/// <param name="Right">The sizes of a body with two right sides.</param>
internal readonly record struct BodySides(BoneDimensions Mean, BoneDimensions Left, BoneDimensions Right)
{
    public static BodySides Measure(MotionSource source)
    {
        Vector3[] offsets = new Vector3[BoneHierarchy.BoneCount];
        Vector3[] endSites = new Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        return new BodySides(
            new SkeletonBody(offsets, endSites, source.Variant).Measure(),
            new SkeletonBody(Mirror(offsets, fromLeft: true), Mirror(endSites, fromLeft: true), source.Variant).Measure(),
            new SkeletonBody(Mirror(offsets, fromLeft: false), Mirror(endSites, fromLeft: false), source.Variant).Measure());
    }

    private static Vector3[] Mirror(Vector3[] places, bool fromLeft)
    {
        Vector3[] mirrored = [.. places];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (BoneHierarchy.TryFind(OtherSide(bone.ToString(), fromLeft), SkeletonVariant.Neck1, out Bone other) && other != bone)
                mirrored[(int)bone] = places[(int)other] * new Vector3(-1, 1, 1);
        }

        return mirrored;
    }

    private static string OtherSide(string name, bool fromLeft) =>
        fromLeft ? name.Replace("Right", "Left", StringComparison.Ordinal) : name.Replace("Left", "Right", StringComparison.Ordinal);
}
