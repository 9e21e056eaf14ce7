using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

// The links of a rig to a variant of the stream. The hips come first, then the other nodes in order.
internal static class RetargetLinks
{
    public static RetargetLink[] Create(TargetRig rig, SkeletonVariant variant)
    {
        List<RetargetLink> links = [];
        int[] sources = new int[rig.Nodes.Length];
        HumanoidBoneSet present = rig.Bones;
        for (int node = 0; node < sources.Length; node++)
        {
            sources[node] = GetSource(rig, node, variant, present);
            if (sources[node] >= 0)
                links.Add(CreateLink(rig, node, sources, variant));
        }

        // Only in flat rigs can bones come before the hips.
        int hips = links.FindIndex(link => link.Node == rig.HipsNode);
        (links[0], links[hips]) = (links[hips], links[0]);
        return [.. links];
    }

    private static int GetSource(TargetRig rig, int node, SkeletonVariant variant, HumanoidBoneSet present)
    {
        Bone? source = rig.GetHumanoidBone(node) is { } bone ? HumanoidMap.GetBone(bone, variant, present) : rig.GetBone(node);
        return source is { } found ? (int)found : -1;
    }

    private static RetargetLink CreateLink(TargetRig rig, int node, int[] sources, SkeletonVariant variant)
    {
        int parent = rig.Nodes[node].Parent;
        int above = parent;
        while (above >= 0 && sources[above] < 0)
            above = rig.Nodes[above].Parent;

        Quaternion toSource = Quaternion.Conjugate(rig.Facing);
        Quaternion parentRest = parent < 0 ? Quaternion.Identity : rig.RestRotations[parent];
        BodyParts part = rig.GetHumanoidBone(node) is { } bone
            ? HumanoidBones.GetPart(bone)
            : HumanoidBones.GetPart((Bone)sources[node], variant);
        return new RetargetLink
        {
            Node = node,
            Source = sources[node],
            SourceAbove = above < 0 ? -1 : sources[above],
            Part = BoneWeights.PartIndex(part),
            Bone = rig.GetHumanoidBone(node) is { } humanoid ? (int)humanoid : sources[node],
            Before = Quaternion.Conjugate(toSource * parentRest),
            After = toSource * rig.RestRotations[node],
            Handedness = rig.HandednessAt(node),
            RestWay = above < 0 ? default : Vector3.Transform(rig.RestPositions[node] - rig.RestPositions[above], toSource),
            Units = new Vector3(Invert(rig.ScaleAbove(node).X), Invert(rig.ScaleAbove(node).Y), Invert(rig.ScaleAbove(node).Z)),
        };
    }

    // Below a scale of zero, positions have no effect.
    private static float Invert(float scale) => scale == 0 ? 0 : 1 / scale;
}
