using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

/// <summary>Characters in a plain T-pose, as large as the default body.</summary>
internal static class TestRigs
{
    /// <summary>Creates the actor's own skeleton, with a node for each bone of the stream.</summary>
    public static TargetRig Actor(SkeletonBody body)
    {
        var nodes = new List<RigNode>();
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            int parent = BoneHierarchy.GetParent(bone, body.Variant) is { } above ? (int)above : -1;
            nodes.Add(new RigNode(bone.ToString(), parent, UnityAxes.ToUnityPosition(body.GetOffset(bone)), Quaternion.Identity));
        }

        return TargetRig.CreateGeneric([.. nodes], [.. Enumerable.Range(0, BoneHierarchy.BoneCount)]);
    }

    /// <summary>Creates nodes for all 55 Humanoid bones, parents first. Node i is bone <c>Order[i]</c>.</summary>
    public static RigNode[] HumanoidNodes(float size = 1)
    {
        int[] index = Indices(Order);
        return
        [
            .. Order.Select(bone => new RigNode(
                bone.ToString(), HumanoidBones.GetParent(bone) is { } parent ? index[(int)parent] : -1, Offset(bone) * size, Quaternion.Identity)),
        ];
    }

    public static HumanoidBone[] Order { get; } =
        [.. Enumerable.Range(0, HumanoidBones.Count).Select(bone => (HumanoidBone)bone).OrderBy(Depth).ThenBy(bone => bone)];

    /// <summary>Returns the node of each bone. -1 for the omitted bones.</summary>
    public static int[] NodeOf(params HumanoidBone[] without)
    {
        int[] nodeByBone = Indices(Order);
        foreach (HumanoidBone bone in without)
            nodeByBone[(int)bone] = -1;

        return nodeByBone;
    }

    public static TargetRig Humanoid(float size = 1, params HumanoidBone[] without) => TargetRig.CreateHumanoid(HumanoidNodes(size), NodeOf(without));

    /// <summary>Returns the same character with a node above all others.</summary>
    public static RigNode[] Under(RigNode top, RigNode[] nodes) => [top with { Parent = -1 }, .. nodes.Select(node => node with { Parent = node.Parent + 1 })];

    public static int[] Under(int[] nodeByBone) => [.. nodeByBone.Select(node => node < 0 ? -1 : node + 1)];

    /// <summary>Returns the actor at rest above the origin.</summary>
    public static BoneTransform[] RestPose(SkeletonBody body)
    {
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(pose);
        return pose;
    }

    public static HumanoidBone Partner(HumanoidBone bone)
    {
        string name = bone.ToString();
        string other = name.StartsWith("Left", StringComparison.Ordinal) ? "Right" + name[4..]
            : name.StartsWith("Right", StringComparison.Ordinal) ? "Left" + name[5..]
            : name;
        return Enum.Parse<HumanoidBone>(other);
    }

    private static int Depth(HumanoidBone bone) => HumanoidBones.GetParent(bone) is { } parent ? Depth(parent) + 1 : 0;

    private static int[] Indices(HumanoidBone[] order)
    {
        int[] index = new int[HumanoidBones.Count];
        for (int i = 0; i < order.Length; i++)
            index[(int)order[i]] = i;

        return index;
    }

    // From one Humanoid bone's source to the next, in the default body. A bone without a source is slightly in front of its parent.
    private static Vector3 Offset(HumanoidBone bone)
    {
        if (HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is not { } source)
            return new Vector3(bone is HumanoidBone.LeftEye ? -0.03f : bone is HumanoidBone.RightEye ? 0.03f : 0, -0.05f, 0.1f);

        Vector3 offset = Vector3.Zero;
        Bone? above = HumanoidBones.GetParent(bone) is { } parent ? HumanoidMap.GetBone(parent, SkeletonVariant.Neck1, HumanoidBoneSet.All) : null;
        for (Bone? step = source; step is { } one && step != above; step = BoneHierarchy.GetParent(one))
            offset += DefaultOffsets.Get(one);

        return UnityAxes.ToUnityPosition(offset);
    }
}
