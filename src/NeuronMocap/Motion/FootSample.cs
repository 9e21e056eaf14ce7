using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

// The middle of each foot in one frame: what a pose and calculation data both have. A foot touches while its middle is as low as it gets
// and hardly moves; one that touches keeps doing so until it is clearly away, so that neither noise nor a slow roll makes it flicker.
internal readonly struct FootSample(Vector3 left, Vector3 right)
{
    // In centimetres and centimetres per second; the best of a search over the recorded takes, and any near them are nearly as good.
    private const float NearGround = 3;
    private const float LeftGround = 5;
    private const float LargestSpeed = 30;
    private const float SpeedOfLeaving = 40;

    private readonly Vector3 _left = left;
    private readonly Vector3 _right = right;

    public float Lowest => Math.Min(_left.Y, _right.Y);

    public static FootSample Of(ReadOnlySpan<BoneTransform> world, SkeletonBody body)
    {
        ForwardKinematics.CheckPose(world, nameof(world));
        return new FootSample(Middle(world, body, Bone.LeftFoot), Middle(world, body, Bone.RightFoot));
    }

    public FootContacts Touches(FootContacts last, in FootSample before, in FootSample after, double seconds, float ground) => new(
        Touches(last.Left, _left.Y - ground, Vector3.Distance(before._left, after._left) / seconds),
        Touches(last.Right, _right.Y - ground, Vector3.Distance(before._right, after._right) / seconds));

    private static Vector3 Middle(ReadOnlySpan<BoneTransform> world, SkeletonBody body, Bone foot) =>
        (world[(int)foot].Position + JointPositions.GetEnd(world, body, foot)) / 2;

    // A speed that is not a number is that of a take of one frame.
    private static bool Touches(bool last, float height, double speed) =>
        height < (last ? LeftGround : NearGround) && !(speed >= (last ? SpeedOfLeaving : LargestSpeed));
}
