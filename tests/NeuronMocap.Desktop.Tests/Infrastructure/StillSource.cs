using System.Numerics;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Desktop.Tests.Infrastructure;

/// <summary>A performer who holds a pose until the test asks for another one.</summary>
internal sealed class StillSource : MotionSource
{
    private static readonly SkeletonBody Body = SkeletonBody.GetDefault();
    private volatile int _angle;

    /// <summary>How far the arms are turned from the T-pose, in degrees.</summary>
    public int Angle
    {
        get => _angle;
        set => _angle = value;
    }

    public override double FrameRate => 120;

    public override long? FrameCount => null;

    public override bool HasDisplacement => true;

    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        int both = _angle;
        Body.CopyRestPose(pose);
        foreach (Bone bone in (Bone[])[Bone.LeftArm, Bone.RightArm])
        {
            float angle = float.DegreesToRadians(bone == Bone.LeftArm ? -both : both);
            pose[(int)bone] = new BoneTransform(pose[(int)bone].Position, Quaternion.CreateFromAxisAngle(Vector3.UnitZ, angle));
        }
    }

    public override FootContacts GetFootContacts(long frame) => new(true, true);
}
