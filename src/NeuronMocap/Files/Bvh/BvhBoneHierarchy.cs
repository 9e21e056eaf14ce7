using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>The hierarchy of Neuron's 59 bones, as Axis Neuron's files have it (manual, Appendix B).</summary>
public static class BvhBoneHierarchy
{
    /// <summary>Makes the hierarchy whose rows are motion packets: values in the same number and order.</summary>
    /// <param name="format">Names of the bones, and order of the rotation channels.</param>
    /// <param name="layout">
    /// Which channels there are: six for every bone with displacement, else six for the hips and three for the others. With a reference, a root of
    /// that name with six channels, at the origin, carries the hips.
    /// </param>
    /// <param name="body">The OFFSETs and End Sites; null for the default body of the format's variant.</param>
    /// <returns>The hierarchy.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such rotation order.</exception>
    public static BvhHierarchy Create(SkeletonFormat format, ChannelLayout layout, SkeletonBody? body = null)
    {
        var builder = new BvhHierarchyBuilder();
        body ??= SkeletonBody.GetDefault(format.Variant);
        BvhChannel[] three = BvhChannels.Rotations(format.RotationOrder);
        BvhChannel[] six = [.. BvhChannels.Positions, .. three];
        BvhJoint? reference = layout.HasReference ? builder.Add(BvhSkeletonMap.ReferenceName, parent: null, Vector3.Zero, six) : null;
        BvhJoint[] joints = new BvhJoint[BoneHierarchy.BoneCount];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            BvhJoint? parent = BoneHierarchy.GetParent(bone, format.Variant) is { } known ? joints[(int)known] : reference;
            joints[(int)bone] = builder.Add(
                BoneHierarchy.GetName(bone, format.Variant),
                parent,
                body.Offsets[(int)bone],
                layout.GetPositionIndex(bone) >= 0 ? six : three,
                DefaultOffsets.TryGetEndSite(bone, out _) ? body.EndSites[(int)bone] : null);
        }

        return builder.Build();
    }
}
