using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Calculation;

// The bone positions of a measured export.
internal static class CalculationPoses
{
    public static BoneTransform[] WorldOf(CalculationSkeleton skeleton, CalculationDocument document, int frame)
    {
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        skeleton.CopyLocalTransforms(document.GetValues(frame), pose);
        ForwardKinematics.ToWorld(pose, pose, skeleton.Body.Variant);
        return pose;
    }

    // The end of a bone in its own axes. For hands, it is the end of the default fingers, which are scaled to match, within a millimetre.
    public static Vector3 EndOf(Bone bone, SkeletonBody body) => bone switch
    {
        Bone.Hips => Vector3.Zero,
        Bone.RightHand => -Vector3.UnitX * LengthOf(body, Bone.RightInHandMiddle, Bone.RightHandMiddle3),
        Bone.LeftHand => Vector3.UnitX * LengthOf(body, Bone.LeftInHandMiddle, Bone.LeftHandMiddle3),
        Bone.RightFoot or Bone.LeftFoot or Bone.Head => body.EndSites[(int)bone],
        _ => body.GetOffset(bone + 1),
    };

    private static float LengthOf(SkeletonBody body, Bone first, Bone last)
    {
        float length = body.EndSites[(int)last].X;
        for (Bone bone = first; bone <= last; bone++)
            length += body.GetOffset(bone).X;

        return MathF.Abs(length);
    }
}
