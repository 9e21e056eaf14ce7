using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Convert;

/// <summary>Writes the body of a take as the HIERARCHY of a BVH file.</summary>
internal static class SourceHierarchy
{
    public static string GetText(InputTake take)
    {
        Vector3[] offsets = new Vector3[BoneHierarchy.BoneCount];
        Vector3[] endSites = new Vector3[BoneHierarchy.BoneCount];
        take.Motion.GetBody(offsets, endSites);
        return BvhHierarchyText.Create(offsets, endSites, new SkeletonFormat(take.Order, take.Motion.Variant), take.Layout);
    }
}
