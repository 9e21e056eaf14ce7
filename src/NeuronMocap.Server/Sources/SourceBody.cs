using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

/// <summary>The body that a performance is about, in the forms that servers tell it in.</summary>
internal static class SourceBody
{
    private const float MetresPerCentimetre = 0.01f;

    /// <summary>
    /// Lengths of the bones, in metres: from a bone's joint to the next joint of its chain, or to its End Site. The spine continues the hips, the
    /// middle finger a hand.
    /// </summary>
    public static float[] GetLengths(MotionSource source)
    {
        Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
        Span<Vector3> endSites = stackalloc Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        float[] lengths = new float[BoneHierarchy.BoneCount];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Vector3 end = DefaultOffsets.TryGetEndSite(bone, out _) ? endSites[(int)bone] : offsets[(int)GetNext(bone)];
            lengths[(int)bone] = end.Length() * MetresPerCentimetre;
        }

        return lengths;
    }

    /// <summary>The text that a BVH file of the performance begins with.</summary>
    public static string GetHierarchy(MotionSource source, RotationOrder order, ChannelLayout layout)
    {
        Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
        Span<Vector3> endSites = stackalloc Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        return BvhHierarchyText.Create(offsets, endSites, new SkeletonFormat(order, source.Variant), layout);
    }

    /// <summary>The twelve sizes of the body.</summary>
    public static BoneDimensions Measure(MotionSource source)
    {
        Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
        Span<Vector3> endSites = stackalloc Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        for (int bone = 0; bone < pose.Length; bone++)
            pose[bone] = new BoneTransform(offsets[bone], Quaternion.Identity);

        return BoneDimensions.Measure(pose, source.Variant, endSites);
    }

    private static Bone GetNext(Bone bone) => bone switch
    {
        Bone.Hips => Bone.Spine,
        Bone.RightHand => Bone.RightInHandMiddle,
        Bone.LeftHand => Bone.LeftInHandMiddle,
        _ => bone + 1,
    };
}
