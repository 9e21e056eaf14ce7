namespace UnityEngine.StandIn;

/// <summary>
/// The goals of feet and hands, as Unity's forum and the reference of <see cref="HumanPose"/> describe them: relative to the body, and divided by the
/// human scale. The goal of a foot is at its sole, the first axis of a goal points along the bone.
/// </summary>
internal static class LimbGoals
{
    /// <summary>Metres from the ankle to the sole.</summary>
    public const float FootHeight = 0.08f;

    public static readonly HumanBodyBones[] Bones = [HumanBodyBones.LeftFoot, HumanBodyBones.RightFoot, HumanBodyBones.LeftHand, HumanBodyBones.RightHand];

    // The rotations of the goals in the T-pose, relative to the root. Those of feet have x down.
    private static readonly Quaternion[] _rest =
    [
        new(-0.5f, 0.5f, -0.5f, 0.5f), new(-0.5f, 0.5f, -0.5f, 0.5f), Quaternion.Euler(0, 180, 0), Quaternion.Euler(0, 0, 0),
    ];

    /// <summary>Returns the rotation from a bone's own axes to those of its goal. The root stands in the T-pose.</summary>
    public static Quaternion[] FindPostRotations(Transform root, HumanDescription description)
    {
        var found = new Quaternion[(int)HumanBodyBones.LastBone];
        Array.Fill(found, Quaternion.identity);
        for (int i = 0; i < Bones.Length; i++)
        {
            string name = HumanTrait.BoneName[(int)Bones[i]];
            string mapped = description.human.First(human => human.humanName == name).boneName;
            Transform bone = root.GetComponentsInChildren<Transform>(true).First(item => item.name == mapped);
            found[(int)Bones[i]] = Quaternion.Inverse(Quaternion.Inverse(root.rotation) * bone.rotation) * _rest[i];
        }

        return found;
    }

    public static void Read(Avatar avatar, HumanBones bones, Transform root, ref HumanPose pose)
    {
        pose.GoalPositions ??= new Vector3[Bones.Length];
        pose.GoalRotations ??= new Quaternion[Bones.Length];
        Transform hips = bones.Get(HumanBodyBones.Hips)!;
        var body = Quaternion.Inverse(hips.rotation);
        for (int i = 0; i < Bones.Length; i++)
        {
            Transform bone = bones.Get(Bones[i])!;
            Quaternion rotation = bone.rotation * avatar.GetPostRotation((int)Bones[i]);
            Vector3 end = root.InverseTransformPoint(bone.position) + (Quaternion.Inverse(root.rotation) * rotation * AlongBone(i));
            Vector3 distance = end - root.InverseTransformPoint(hips.position);
            pose.GoalPositions[i] = body * root.rotation * distance / bones.HipsHeight;
            pose.GoalRotations[i] = body * rotation;
        }
    }

    /// <summary>From the joint of a limb to its goal, along the goal's axes.</summary>
    public static Vector3 AlongBone(int goal) => goal < 2 ? new Vector3(FootHeight, 0, 0) : Vector3.zero;
}
