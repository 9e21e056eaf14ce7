using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>
/// Maps Humanoid bones to bones of the stream. The stream has more bones than a Humanoid rig, so each Humanoid bone stands for a group of them. It
/// follows the last bone of the group and thus receives all rotations of the group. 50 of the 55 bones have a source; toes, eyes and jaw have none.
/// </summary>
public static class HumanoidMap
{
    /// <summary>Gets the bone of the stream whose world rotation a Humanoid bone takes over.</summary>
    /// <param name="bone">A bone of the character.</param>
    /// <param name="variant">How the stream divides spine and neck.</param>
    /// <param name="present">
    /// The bones that the character has. The topmost of spine, chest and upper chest follows the bone that is the parent of the shoulders.
    /// </param>
    /// <returns>A bone of the stream, or null for toes, eyes and jaw, which stay at rest.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static Bone? GetBone(HumanoidBone bone, SkeletonVariant variant, HumanoidBoneSet present)
    {
        Bone topOfSpine = variant == SkeletonVariant.Spine3 ? Bone.Neck : Bone.Spine2;
        bool hasChest = present.Contains(HumanoidBone.Chest);
        bool hasUpperChest = present.Contains(HumanoidBone.UpperChest);
        return (HumanoidBone)HumanoidBones.CheckedIndex(bone) switch
        {
            HumanoidBone.Hips => Bone.Hips,
            HumanoidBone.Spine => hasChest || hasUpperChest ? Bone.Spine : topOfSpine,
            HumanoidBone.Chest => hasUpperChest ? Bone.Spine1 : topOfSpine,
            HumanoidBone.UpperChest => topOfSpine,
            HumanoidBone.Neck => Bone.Neck1,
            HumanoidBone.Head => Bone.Head,
            HumanoidBone.LeftUpperLeg => Bone.LeftUpLeg,
            HumanoidBone.LeftLowerLeg => Bone.LeftLeg,
            HumanoidBone.LeftFoot => Bone.LeftFoot,
            HumanoidBone.RightUpperLeg => Bone.RightUpLeg,
            HumanoidBone.RightLowerLeg => Bone.RightLeg,
            HumanoidBone.RightFoot => Bone.RightFoot,
            HumanoidBone.LeftShoulder => Bone.LeftShoulder,
            HumanoidBone.LeftUpperArm => Bone.LeftArm,
            HumanoidBone.LeftLowerArm => Bone.LeftForeArm,
            HumanoidBone.LeftHand => Bone.LeftHand,
            HumanoidBone.RightShoulder => Bone.RightShoulder,
            HumanoidBone.RightUpperArm => Bone.RightArm,
            HumanoidBone.RightLowerArm => Bone.RightForeArm,
            HumanoidBone.RightHand => Bone.RightHand,
            _ when HumanoidBones.IsFinger(bone) => GetFinger(bone - HumanoidBone.LeftThumbProximal),
            _ => null,
        };
    }

    // Three bones for each finger, five fingers for each hand, left hand first. In the stream, a palm bone precedes each finger except the thumb.
    private static Bone GetFinger(int index)
    {
        Bone thumb = index < 15 ? Bone.LeftHandThumb1 : Bone.RightHandThumb1;
        return thumb + (index % 15 / 3 * 4) + (index % 3);
    }
}
