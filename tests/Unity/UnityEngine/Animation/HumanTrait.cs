using UnityEngine.StandIn;

namespace UnityEngine;

public static class HumanTrait
{
    private static readonly HumanBodyBones[] _required =
    [
        HumanBodyBones.Hips, HumanBodyBones.Spine, HumanBodyBones.Head,
        HumanBodyBones.LeftUpperArm, HumanBodyBones.RightUpperArm, HumanBodyBones.LeftLowerArm, HumanBodyBones.RightLowerArm,
        HumanBodyBones.LeftHand, HumanBodyBones.RightHand,
        HumanBodyBones.LeftUpperLeg, HumanBodyBones.RightUpperLeg, HumanBodyBones.LeftLowerLeg, HumanBodyBones.RightLowerLeg,
        HumanBodyBones.LeftFoot, HumanBodyBones.RightFoot,
    ];

    /// <summary>The names of the enumeration, with spaces only in names of finger bones: "Left Index Proximal".</summary>
    public static string[] BoneName { get; } = [.. Enumerable.Range(0, BoneCount).Select(static bone => Spell((HumanBodyBones)bone))];

    public static string[] MuscleName { get; } = [.. MuscleNames.All];

    public static int BoneCount => (int)HumanBodyBones.LastBone;

    public static int MuscleCount => MuscleName.Length;

    public static int RequiredBoneCount => _required.Length;

    public static bool RequiredBone(int i) => _required.Contains((HumanBodyBones)i);

    /// <returns>The parent in Unity's humanoid, including optional bones. -1 for the hips.</returns>
    public static int GetParentBone(int i)
    {
        var bone = (HumanBodyBones)i;
        string name = bone.ToString();
        bool isLeft = name.StartsWith("Left", StringComparison.Ordinal);
        HumanBodyBones Side(HumanBodyBones left, HumanBodyBones right) => isLeft ? left : right;
        return (int)(bone switch
        {
            HumanBodyBones.Hips => (HumanBodyBones)(-1),
            HumanBodyBones.Spine or HumanBodyBones.LeftUpperLeg or HumanBodyBones.RightUpperLeg => HumanBodyBones.Hips,
            HumanBodyBones.Chest => HumanBodyBones.Spine,
            HumanBodyBones.UpperChest => HumanBodyBones.Chest,
            HumanBodyBones.Neck or HumanBodyBones.LeftShoulder or HumanBodyBones.RightShoulder => HumanBodyBones.UpperChest,
            HumanBodyBones.Head => HumanBodyBones.Neck,
            HumanBodyBones.LeftEye or HumanBodyBones.RightEye or HumanBodyBones.Jaw => HumanBodyBones.Head,
            HumanBodyBones.LeftToes or HumanBodyBones.RightToes => Side(HumanBodyBones.LeftFoot, HumanBodyBones.RightFoot),
            _ when name.EndsWith("Proximal", StringComparison.Ordinal) => Side(HumanBodyBones.LeftHand, HumanBodyBones.RightHand),
            >= HumanBodyBones.LeftThumbProximal => bone - 1,
            _ => bone - 2,
        });
    }

    private static string Spell(HumanBodyBones bone) => bone is >= HumanBodyBones.LeftThumbProximal and < HumanBodyBones.UpperChest
        ? string.Concat(bone.ToString().Select(static (letter, index) => index > 0 && char.IsUpper(letter) ? $" {letter}" : $"{letter}"))
        : bone.ToString();
}
