using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

internal static class RetargetAssert
{
    public static RetargetedPose Retarget(TargetRig rig, SkeletonBody body, BoneTransform[] pose)
    {
        var result = new RetargetedPose(rig);
        Assert.True(new Retargeter(rig, body).TryRetarget(pose, result));
        return result;
    }

    // The second rig may have additional nodes above those of the first.
    public static void AssertAlike(RetargetedPose expected, RetargetedPose actual, int above = 1)
    {
        AssertNear(expected.HipsLocalPosition, actual.HipsLocalPosition, 1e-5f);
        for (int node = 0; node < expected.LocalRotations.Length; node++)
            AssertTurn(expected.LocalRotations[node], actual.LocalRotations[node + above], 3e-6, expected.Rig.Nodes[node].Name);
    }

    public static void AssertTurn(Quaternion expected, Quaternion actual, double tolerance, string where)
    {
        double angle = Affine.Turned(expected).AngleTo(actual);
        Assert.True(angle <= tolerance, $"{where}: off by {angle:e2} rad");
    }

    public static void AssertNear(Vector3 expected, Vector3 actual, float tolerance) =>
        Assert.True(Vector3.Distance(expected, actual) <= tolerance, $"{expected} and {actual}");
}
