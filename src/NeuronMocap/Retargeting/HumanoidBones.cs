using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>Names, parents and parts of the 55 Humanoid bones. Thread-safe.</summary>
public static class HumanoidBones
{
    /// <summary>Number of bones.</summary>
    public const int Count = 55;

    private static readonly string[] Names = [.. Enumerable.Range(0, Count).Select(index => Spell((HumanoidBone)index))];

    /// <summary>Gets the name that Unity's HumanTrait.BoneName gives the bone. A HumanDescription must spell it the same way.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>A name such as "LeftUpperArm" or, with spaces, "Left Index Proximal".</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static string GetName(HumanoidBone bone) => Names[CheckedIndex(bone)];

    /// <summary>Determines whether a bone is required: without it, Unity cannot create a Humanoid avatar.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>True for 15 of the bones.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static bool IsRequired(HumanoidBone bone) => (HumanoidBone)CheckedIndex(bone) switch
    {
        HumanoidBone.Chest or HumanoidBone.Neck or HumanoidBone.LeftShoulder or HumanoidBone.RightShoulder => false,
        _ => bone <= HumanoidBone.RightHand,
    };

    /// <summary>Gets the parent of a bone in a rig that has all bones.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>The parent, or null for the hips.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static HumanoidBone? GetParent(HumanoidBone bone) => (HumanoidBone)CheckedIndex(bone) switch
    {
        HumanoidBone.Hips => null,
        HumanoidBone.LeftUpperLeg or HumanoidBone.RightUpperLeg or HumanoidBone.Spine => HumanoidBone.Hips,
        HumanoidBone.Chest => HumanoidBone.Spine,
        HumanoidBone.UpperChest => HumanoidBone.Chest,
        HumanoidBone.Neck or HumanoidBone.LeftShoulder or HumanoidBone.RightShoulder => HumanoidBone.UpperChest,
        HumanoidBone.Head => HumanoidBone.Neck,
        HumanoidBone.LeftEye or HumanoidBone.RightEye or HumanoidBone.Jaw => HumanoidBone.Head,
        HumanoidBone.LeftToes => HumanoidBone.LeftFoot,
        HumanoidBone.RightToes => HumanoidBone.RightFoot,
        < HumanoidBone.LeftToes => bone - 2,
        _ when !IsFirstOfFinger(bone) => bone - 1,
        < HumanoidBone.RightThumbProximal => HumanoidBone.LeftHand,
        _ => HumanoidBone.RightHand,
    };

    /// <summary>Gets the part of the body that a bone belongs to.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>One of the nine parts.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static BodyParts GetPart(HumanoidBone bone) => (HumanoidBone)CheckedIndex(bone) switch
    {
        HumanoidBone.Hips => BodyParts.Hips,
        HumanoidBone.Spine or HumanoidBone.Chest or HumanoidBone.UpperChest => BodyParts.Spine,
        HumanoidBone.Neck or HumanoidBone.Head or HumanoidBone.LeftEye or HumanoidBone.RightEye or HumanoidBone.Jaw => BodyParts.Head,
        >= HumanoidBone.RightThumbProximal => BodyParts.RightFingers,
        >= HumanoidBone.LeftThumbProximal => BodyParts.LeftFingers,

        // From thighs to feet, from shoulders to hands, and at the toes, odd numbers are on the left and even numbers on the right.
        < HumanoidBone.Spine or HumanoidBone.LeftToes or HumanoidBone.RightToes =>
            bone is HumanoidBone.LeftUpperLeg or HumanoidBone.LeftLowerLeg or HumanoidBone.LeftFoot or HumanoidBone.LeftToes
                ? BodyParts.LeftLeg
                : BodyParts.RightLeg,
        _ => ((int)bone & 1) != 0 ? BodyParts.LeftArm : BodyParts.RightArm,
    };

    /// <summary>Gets the part of the body that a bone of the stream belongs to.</summary>
    /// <param name="bone">The bone.</param>
    /// <param name="variant">Determines whether the bone at index 10 belongs to the spine or to the neck.</param>
    /// <returns>One of the nine parts. The palm bones of the hands belong to the fingers.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static BodyParts GetPart(Bone bone, SkeletonVariant variant = SkeletonVariant.Neck1) => (Bone)BoneHierarchy.CheckedIndex(bone) switch
    {
        Bone.Hips => BodyParts.Hips,
        <= Bone.RightFoot => BodyParts.RightLeg,
        <= Bone.LeftFoot => BodyParts.LeftLeg,
        <= Bone.Spine2 => BodyParts.Spine,
        Bone.Neck when variant == SkeletonVariant.Spine3 => BodyParts.Spine,
        <= Bone.Head => BodyParts.Head,
        <= Bone.RightHand => BodyParts.RightArm,
        <= Bone.RightHandPinky3 => BodyParts.RightFingers,
        <= Bone.LeftHand => BodyParts.LeftArm,
        _ => BodyParts.LeftFingers,
    };

    internal static int CheckedIndex(HumanoidBone bone)
    {
        int index = (int)bone;
        if ((uint)index >= Count)
            throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone must be one of the 55 Humanoid bones, 0 to 54.");

        return index;
    }

    internal static bool IsFinger(HumanoidBone bone) => bone is >= HumanoidBone.LeftThumbProximal and <= HumanoidBone.RightLittleDistal;

    private static bool IsFirstOfFinger(HumanoidBone bone) => (bone - HumanoidBone.LeftThumbProximal) % 3 == 0;

    private static string Spell(HumanoidBone bone)
    {
        string name = bone.ToString();
        return IsFinger(bone) ? string.Concat(name.Select((letter, i) => i > 0 && char.IsUpper(letter) ? $" {letter}" : $"{letter}")) : name;
    }
}
