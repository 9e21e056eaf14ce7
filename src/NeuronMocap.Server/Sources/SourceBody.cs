using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

/// <summary>The body that a performance is about, in the forms that a server tells it in.</summary>
internal static class SourceBody
{
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
}
