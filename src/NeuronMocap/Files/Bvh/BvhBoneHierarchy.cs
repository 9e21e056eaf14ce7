using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>Creates the hierarchy of the 59 Neuron bones, as in files of Axis Neuron (manual, Appendix B).</summary>
public static class BvhBoneHierarchy
{
    /// <summary>Creates a hierarchy whose rows match motion packets: the values have the same number and order.</summary>
    /// <param name="format">The names of the bones and the order of the rotation channels.</param>
    /// <param name="layout">
    /// The channels. With displacement, every bone has six; otherwise the hips have six and the other bones three. With a reference, the hips are a
    /// child of a root of that name, which has six channels and is at the origin.
    /// </param>
    /// <param name="body">The OFFSETs and End Sites; null for the default body of the format's variant.</param>
    /// <returns>The hierarchy.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static BvhHierarchy Create(SkeletonFormat format, ChannelLayout layout, SkeletonBody? body = null)
    {
        var builder = new BvhHierarchyBuilder();
        body ??= SkeletonBody.GetDefault(format.Variant);
        BvhChannel[] three = BvhChannels.Rotations(format.RotationOrder);
        BvhChannel[] six = [.. BvhChannels.Positions, .. three];
        BvhJoint? reference = layout.HasReference ? builder.Add(BvhBoneNames.Reference, parent: null, Vector3.Zero, six) : null;
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
