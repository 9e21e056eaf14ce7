using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Kinematics;

// The lower end of each foot in one frame. A foot touches while it is near the ground and hardly moves; one that touches keeps doing so until
// it is clearly away, so that neither noise nor a slow roll makes it flicker.
internal readonly struct FootSample
{
    private const float NearGround = 3; // cm
    private const float LeftGround = 4;
    private const float LargestSpeed = 30; // cm/s
    private const float SpeedOfLeaving = 45;

    private readonly Vector3 _left;
    private readonly Vector3 _right;

    public FootSample(ReadOnlySpan<BoneTransform> world, SkeletonBody body)
    {
        ForwardKinematics.CheckPose(world, nameof(world));
        _left = Lower(world[(int)Bone.LeftFoot].Position, JointPositions.GetEnd(world, body, Bone.LeftFoot));
        _right = Lower(world[(int)Bone.RightFoot].Position, JointPositions.GetEnd(world, body, Bone.RightFoot));
    }

    public float Lowest => Math.Min(_left.Y, _right.Y);

    public FootContacts Touches(FootContacts last, in FootSample before, in FootSample after, double seconds, float ground) => new(
        Touches(last.Left, _left.Y - ground, Vector3.Distance(before._left, after._left) / seconds),
        Touches(last.Right, _right.Y - ground, Vector3.Distance(before._right, after._right) / seconds));

    private static bool Touches(bool last, float height, double speed) =>
        height < (last ? LeftGround : NearGround) && !(speed >= (last ? SpeedOfLeaving : LargestSpeed));

    private static Vector3 Lower(Vector3 one, Vector3 other) => other.Y < one.Y ? other : one;
}
