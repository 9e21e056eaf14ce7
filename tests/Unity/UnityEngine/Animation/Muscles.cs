namespace UnityEngine.StandIn;

/// <summary>Each muscle as an angle, in half turns, about one of three axes of its bone, away from the T-pose.</summary>
internal static class Muscles
{
    private static readonly (HumanBodyBones Bone, int First, int Count)[] _muscles = [.. Assign()];

    public static void Read(HumanBones bones, float[] values)
    {
        foreach ((HumanBodyBones bone, int first, int count) in _muscles)
        {
            if (bones.Get(bone) is not { } transform)
                continue;

            Quaternion turn = Quaternion.Inverse(bones.GetRest(bone)) * transform.localRotation;
            turn.ToAngleAxis(out float angle, out Vector3 axis);
            Vector3 parts = axis * (Mathf.DeltaAngle(0, angle) / 180);
            for (int i = 0; i < count; i++)
                values[first + i] = parts[i];
        }
    }

    public static void Write(HumanBones bones, float[] values)
    {
        foreach ((HumanBodyBones bone, int first, int count) in _muscles)
        {
            if (bones.Get(bone) is not { } transform)
                continue;

            Vector3 parts = default;
            for (int i = 0; i < count; i++)
                parts[i] = values[first + i];

            transform.localRotation = bones.GetRest(bone) * Quaternion.AngleAxis(parts.magnitude * 180, parts);
        }
    }

    private static IEnumerable<(HumanBodyBones Bone, int First, int Count)> Assign()
    {
        int next = 0;
        (HumanBodyBones, int, int) Take(HumanBodyBones bone, int count)
        {
            next += count;
            return (bone, next - count, count);
        }

        foreach (HumanBodyBones bone in (HumanBodyBones[])[HumanBodyBones.Spine, HumanBodyBones.Chest, HumanBodyBones.UpperChest, HumanBodyBones.Neck, HumanBodyBones.Head])
            yield return Take(bone, 3);

        foreach (HumanBodyBones bone in (HumanBodyBones[])[HumanBodyBones.LeftEye, HumanBodyBones.RightEye, HumanBodyBones.Jaw])
            yield return Take(bone, 2);

        for (int side = 0; side < 2; side++)
        {
            yield return Take(HumanBodyBones.LeftUpperLeg + side, 3);
            yield return Take(HumanBodyBones.LeftLowerLeg + side, 2);
            yield return Take(HumanBodyBones.LeftFoot + side, 2);
            yield return Take(HumanBodyBones.LeftToes + side, 1);
        }

        for (int side = 0; side < 2; side++)
        {
            yield return Take(HumanBodyBones.LeftShoulder + side, 2);
            yield return Take(HumanBodyBones.LeftUpperArm + side, 3);
            yield return Take(HumanBodyBones.LeftLowerArm + side, 2);
            yield return Take(HumanBodyBones.LeftHand + side, 2);
        }

        for (HumanBodyBones bone = HumanBodyBones.LeftThumbProximal; bone < HumanBodyBones.UpperChest; bone++)
            yield return Take(bone, bone.ToString().EndsWith("Proximal", StringComparison.Ordinal) ? 2 : 1);
    }
}
