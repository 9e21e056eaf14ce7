using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

/// <summary>The body of a source, in the formats in which servers send it.</summary>
internal static class SourceBody
{
    private const float MetresPerCentimetre = 0.01f;

    /// <summary>
    /// Gets the lengths of the bones in metres, from a bone's joint to the next joint of its chain, or to its End Site.
    /// </summary>
    /// <remarks>The spine continues the hips, and the middle finger continues a hand.</remarks>
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

    /// <summary>Gets the hierarchy text at the start of a BVH file of the source.</summary>
    public static string GetHierarchy(MotionSource source, RotationOrder order, ChannelLayout layout)
    {
        Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
        Span<Vector3> endSites = stackalloc Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        return BvhHierarchyText.Create(offsets, endSites, new SkeletonFormat(order, source.Variant), layout);
    }

    /// <summary>Gets the twelve sizes of the body.</summary>
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
