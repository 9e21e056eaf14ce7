using System.Numerics;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Server.Sources;

// Measurements of poses: positions in the world, and angles that are exact even when small.
internal static class ActorMeasures
{
    public const int LapSeconds = 40;

    // Tip of the toes (the End Site), the point below the ankle, and the back of the heel, in the foot's axes, in centimetres.
    private static readonly Vector3[] SolePoints = [new(0, -10, 15.75f), new(0, -10, 0), new(0, -10, -5)];

    public static BoneTransform[] GetPose(MotionSource source, long frame)
    {
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        source.GetPose(frame, pose);
        return pose;
    }

    public static BoneTransform[] GetWorld(MotionSource source, long frame)
    {
        BoneTransform[] world = GetPose(source, frame);
        ForwardKinematics.ToWorld(world, world, source.Variant);
        return world;
    }

    public static Vector3[] GetSole(BoneTransform foot) => [.. SolePoints.Select(foot.TransformPoint)];

    public static double Degrees(Quaternion from, Quaternion to)
    {
        Quaternion turn = Quaternion.Conjugate(from) * to;
        double sine = new Vector3(turn.X, turn.Y, turn.Z).Length();
        return 2 * Math.Atan2(sine, Math.Abs(turn.W)) * (180 / Math.PI);
    }

    public static double Degrees(Quaternion rotation) => Degrees(Quaternion.Identity, rotation);
}
