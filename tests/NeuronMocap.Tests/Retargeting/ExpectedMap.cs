using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

/// <summary>The full map from Humanoid bones to bones of the stream.</summary>
internal static class ExpectedMap
{
    private static readonly string[] Lines =
    [
        "Hips Hips", "Neck Neck1", "Head Head",
        "LeftUpperLeg LeftUpLeg", "LeftLowerLeg LeftLeg", "LeftFoot LeftFoot",
        "RightUpperLeg RightUpLeg", "RightLowerLeg RightLeg", "RightFoot RightFoot",
        "LeftShoulder LeftShoulder", "LeftUpperArm LeftArm", "LeftLowerArm LeftForeArm", "LeftHand LeftHand",
        "RightShoulder RightShoulder", "RightUpperArm RightArm", "RightLowerArm RightForeArm", "RightHand RightHand",
        "LeftThumbProximal LeftHandThumb1", "LeftThumbIntermediate LeftHandThumb2", "LeftThumbDistal LeftHandThumb3",
        "LeftIndexProximal LeftHandIndex1", "LeftIndexIntermediate LeftHandIndex2", "LeftIndexDistal LeftHandIndex3",
        "LeftMiddleProximal LeftHandMiddle1", "LeftMiddleIntermediate LeftHandMiddle2", "LeftMiddleDistal LeftHandMiddle3",
        "LeftRingProximal LeftHandRing1", "LeftRingIntermediate LeftHandRing2", "LeftRingDistal LeftHandRing3",
        "LeftLittleProximal LeftHandPinky1", "LeftLittleIntermediate LeftHandPinky2", "LeftLittleDistal LeftHandPinky3",
        "RightThumbProximal RightHandThumb1", "RightThumbIntermediate RightHandThumb2", "RightThumbDistal RightHandThumb3",
        "RightIndexProximal RightHandIndex1", "RightIndexIntermediate RightHandIndex2", "RightIndexDistal RightHandIndex3",
        "RightMiddleProximal RightHandMiddle1", "RightMiddleIntermediate RightHandMiddle2", "RightMiddleDistal RightHandMiddle3",
        "RightRingProximal RightHandRing1", "RightRingIntermediate RightHandRing2", "RightRingDistal RightHandRing3",
        "RightLittleProximal RightHandPinky1", "RightLittleIntermediate RightHandPinky2", "RightLittleDistal RightHandPinky3",
    ];

    // The sources of the trunk: variant, whether there is a chest and an upper chest; then the sources of spine, chest and upper chest.
    private static readonly (SkeletonVariant Variant, bool Chest, bool UpperChest, Bone[] Sources)[] Trunks =
    [
        (SkeletonVariant.Neck1, false, false, [Bone.Spine2]),
        (SkeletonVariant.Neck1, true, false, [Bone.Spine, Bone.Spine2]),
        (SkeletonVariant.Neck1, false, true, [Bone.Spine, Bone.Hips, Bone.Spine2]),
        (SkeletonVariant.Neck1, true, true, [Bone.Spine, Bone.Spine1, Bone.Spine2]),
        (SkeletonVariant.Spine3, false, false, [Bone.Neck]),
        (SkeletonVariant.Spine3, true, false, [Bone.Spine, Bone.Neck]),
        (SkeletonVariant.Spine3, false, true, [Bone.Spine, Bone.Hips, Bone.Neck]),
        (SkeletonVariant.Spine3, true, true, [Bone.Spine, Bone.Spine1, Bone.Neck]),
    ];

    private static readonly Dictionary<HumanoidBone, Bone> Map = Lines.Select(line => line.Split(' '))
        .ToDictionary(names => Enum.Parse<HumanoidBone>(names[0]), names => Enum.Parse<Bone>(names[1]));

    public static Bone? Source(HumanoidBone bone, SkeletonVariant variant, HumanoidBoneSet present)
    {
        if (bone is not (HumanoidBone.Spine or HumanoidBone.Chest or HumanoidBone.UpperChest))
            return Map.TryGetValue(bone, out Bone source) ? source : null;

        Bone[] trunk = Trunks.Single(trunk => trunk.Variant == variant
            && trunk.Chest == present.Contains(HumanoidBone.Chest)
            && trunk.UpperChest == present.Contains(HumanoidBone.UpperChest)).Sources;
        return trunk[bone == HumanoidBone.Spine ? 0 : bone == HumanoidBone.Chest ? 1 : 2];
    }

    /// <summary>The source of each node of a Humanoid rig.</summary>
    public static Bone?[] Sources(RandomRig rig, SkeletonVariant variant)
    {
        var sources = new Bone?[rig.Nodes.Length];
        for (int bone = 0; bone < HumanoidBones.Count; bone++)
        {
            if (rig.NodeOf[bone] >= 0)
                sources[rig.NodeOf[bone]] = Source((HumanoidBone)bone, variant, rig.Bones);
        }

        return sources;
    }
}
