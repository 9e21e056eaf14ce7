using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Osc;

/// <summary>
/// The skeleton that VMC describes poses of: Humanoid bones whose rotations are all zero in the T-pose. Each bone is where the actor's is, so the poses
/// have the actor's own positions in Unity's axes.
/// </summary>
internal sealed class VmcRig
{
    private readonly Retargeter _retargeter;
    private readonly RetargetedPose _pose;

    public VmcRig(SkeletonVariant variant)
    {
        var body = SkeletonBody.GetDefault(variant);
        List<RigNode> nodes = [];
        int[] nodeByBone = new int[HumanoidBones.Count];
        Array.ForEach(Enumerable.Range(0, HumanoidBones.Count).ToArray(), bone => nodeByBone[bone] = -1);
        Add(HumanoidBone.Hips, -1, default);

        var rig = TargetRig.CreateHumanoid([.. nodes], nodeByBone, Quaternion.Identity);
        Bones = [.. nodes.Select((_, node) => rig.GetHumanoidBone(node)!.Value)];
        _retargeter = new Retargeter(rig, body, new RetargetOptions { Displacement = true, Scale = 1 });
        _pose = new RetargetedPose(rig);

        // Children of a bone without a source have no source either.
        void Add(HumanoidBone bone, int parent, Vector3 parentPlace)
        {
            if (HumanoidMap.GetBone(bone, variant, HumanoidBoneSet.All) is not { } source)
                return;

            Vector3 place = PlaceOf(source, body);
            nodes.Add(new RigNode(bone.ToString(), parent, UnityAxes.ToUnityPosition(place - parentPlace), Quaternion.Identity));
            int node = nodeByBone[(int)bone] = nodes.Count - 1;
            for (int child = 0; child < HumanoidBones.Count; child++)
            {
                if (HumanoidBones.GetParent((HumanoidBone)child) == bone)
                    Add((HumanoidBone)child, node, place);
            }
        }
    }

    /// <summary>The bones, in the order of the values. The hips are the first.</summary>
    public IReadOnlyList<HumanoidBone> Bones { get; }

    /// <summary>Positions relative to the parent, in metres.</summary>
    public ReadOnlySpan<Vector3> Positions => _pose.LocalPositions;

    /// <summary>Rotations relative to the parent.</summary>
    public ReadOnlySpan<Quaternion> Rotations => _pose.LocalRotations;

    /// <summary>Computes a pose. Returns false if a value is not finite.</summary>
    public bool TryPose(ReadOnlySpan<BoneTransform> local) => _retargeter.TryRetarget(local, _pose);

    private static Vector3 PlaceOf(Bone bone, SkeletonBody body)
    {
        Vector3 place = body.GetOffset(bone);
        for (Bone? parent = BoneHierarchy.GetParent(bone, body.Variant); parent is { } above; parent = BoneHierarchy.GetParent(above, body.Variant))
            place += body.GetOffset(above);

        return place;
    }
}
