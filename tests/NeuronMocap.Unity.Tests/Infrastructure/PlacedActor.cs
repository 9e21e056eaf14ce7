using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>An actor with one arm raised, whose hips a test puts somewhere. The left foot touches the ground.</summary>
internal sealed class PlacedActor : MotionSource
{
    private volatile Tuple<Vector3, float> _place = new(Vector3.zero, 0);

    public override double FrameRate => 100;

    public override long? FrameCount => null;

    public override bool HasDisplacement => true;

    /// <summary>Moves the actor over the floor.</summary>
    /// <param name="position">In Unity's axes and metres, above the height of the hips.</param>
    /// <param name="heading">In degrees, positive to the right.</param>
    public void Put(Vector3 position, float heading) => _place = new(position, heading);

    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        SkeletonBody.GetDefault().CopyRestPose(pose);
        (Vector3 position, float heading) = _place;
        pose[0] = new BoneTransform(pose[0].Position + position.ToStreamPosition(), Quaternion.Euler(0, heading, 0).ToStreamRotation());
        BoneTransform arm = pose[(int)Bone.LeftArm];
        pose[(int)Bone.LeftArm] = new BoneTransform(arm.Position, Quaternion.Euler(10, 20, -60).ToStreamRotation());
    }

    public override FootContacts GetFootContacts(long frame) => new(true, false);
}
