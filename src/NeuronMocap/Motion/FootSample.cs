using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

// The middle of each foot in one frame, which both a pose and calculation data contain. A foot touches the ground when its middle is low and hardly
// moves. It keeps touching until it is clearly away. Noise or a slow roll of the foot therefore do not make the result flicker.
internal readonly struct FootSample(Vector3 left, Vector3 right)
{
    // In centimetres and centimetres per second. A search over the recorded takes found these values; similar values are nearly as good.
    private const float NearGround = 3;
    private const float LeftGround = 5;
    private const float LargestSpeed = 30;
    private const float SpeedOfLeaving = 40;

    private readonly Vector3 _left = left;
    private readonly Vector3 _right = right;

    public float Lowest => Math.Min(_left.Y, _right.Y);

    public bool IsFinite => IsNumber(_left) && IsNumber(_right);

    public static FootSample Of(ReadOnlySpan<BoneTransform> world, SkeletonBody body)
    {
        ForwardKinematics.CheckPose(world, nameof(world));
        return new FootSample(Middle(world, body, Bone.LeftFoot), Middle(world, body, Bone.RightFoot));
    }

    public FootContacts Touches(FootContacts last, in FootSample before, in FootSample after, double seconds, float ground) => new(
        Touches(last.Left, _left.Y - ground, Vector3.Distance(before._left, after._left) / seconds),
        Touches(last.Right, _right.Y - ground, Vector3.Distance(before._right, after._right) / seconds));

    private static bool IsNumber(Vector3 point) => float.IsFinite(point.X) && float.IsFinite(point.Y) && float.IsFinite(point.Z);

    private static Vector3 Middle(ReadOnlySpan<BoneTransform> world, SkeletonBody body, Bone foot) =>
        (world[(int)foot].Position + JointPositions.GetEnd(world, body, foot)) / 2;

    // In a take with one usable frame, the speed is not a number.
    private static bool Touches(bool last, float height, double speed) =>
        height < (last ? LeftGround : NearGround) && !(speed >= (last ? SpeedOfLeaving : LargestSpeed));
}
