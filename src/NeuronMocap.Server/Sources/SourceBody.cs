using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

/// <summary>The body that a performance is about, taken from its first pose: only positions count, and those of all bones but the hips stay.</summary>
internal static class SourceBody
{
    private const float MetresPerCentimetre = 0.01f;

    /// <summary>Places of the bones relative to their parents, in cm. The hips' own is their height in the first pose, above the origin.</summary>
    public static Vector3[] GetOffsets(MotionSource source)
    {
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        source.GetPose(0, pose);
        var offsets = new Vector3[BoneHierarchy.BoneCount];
        for (int bone = 0; bone < offsets.Length; bone++)
            offsets[bone] = pose[bone].Position;

        offsets[(int)Bone.Hips] = new Vector3(0, offsets[(int)Bone.Hips].Y, 0);
        return offsets;
    }

    /// <summary>
    /// Lengths of the bones, in metres: from a bone's joint to the next joint of its chain, or to its End Site, for which the default body's is
    /// taken. The spine continues the hips, the middle finger a hand.
    /// </summary>
    public static float[] GetLengths(MotionSource source)
    {
        Vector3[] offsets = GetOffsets(source);
        var lengths = new float[offsets.Length];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Vector3 end = DefaultOffsets.TryGetEndSite(bone, out Vector3 endSite) ? endSite : offsets[(int)GetNext(bone)];
            lengths[(int)bone] = end.Length() * MetresPerCentimetre;
        }

        return lengths;
    }

    private static Bone GetNext(Bone bone) => bone switch
    {
        Bone.Hips => Bone.Spine,
        Bone.RightHand => Bone.RightInHandMiddle,
        Bone.LeftHand => Bone.LeftInHandMiddle,
        _ => bone + 1,
    };
}
