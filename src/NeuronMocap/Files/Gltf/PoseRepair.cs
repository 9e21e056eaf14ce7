using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Gltf;

// A file with a value that is not a number is not valid. A bone with such a value keeps its last valid transform.
internal sealed class PoseRepair
{
    // In centimetres. Beyond a hundred kilometres, a value is an error of the stream.
    private const float Farthest = 1e7f;

    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];

    public PoseRepair(SkeletonBody body) => body.CopyRestPose(_pose);

    public ReadOnlySpan<BoneTransform> Pose => _pose;

    // Takes over a pose with unit quaternions. Returns false if it had to be repaired.
    public bool Set(ReadOnlySpan<BoneTransform> pose)
    {
        bool isValid = true;
        for (int bone = 0; bone < _pose.Length; bone++)
        {
            Vector3 position = pose[bone].Position;
            Quaternion rotation = pose[bone].Rotation;
            float length = rotation.Length();
            bool isTurn = length is > 1e-3f and < 1e3f;
            bool isPlace = IsValid(position);
            isValid &= isTurn && isPlace;
            _pose[bone] = new BoneTransform(
                isPlace ? position : _pose[bone].Position, isTurn ? Quaternion.Normalize(rotation) : _pose[bone].Rotation);
        }

        return isValid;
    }

    // Invalid sizes are those of the default body.
    public static SkeletonBody Of(SkeletonBody body)
    {
        SkeletonBody usual = SkeletonBody.GetDefault(body.Variant);
        Vector3[] offsets = body.Offsets.ToArray();
        Vector3[] ends = body.EndSites.ToArray();
        bool isValid = true;
        for (int bone = 0; bone < offsets.Length; bone++)
        {
            isValid &= IsValid(offsets[bone]) && IsValid(ends[bone]);
            offsets[bone] = IsValid(offsets[bone]) ? offsets[bone] : usual.Offsets[bone];
            ends[bone] = IsValid(ends[bone]) ? ends[bone] : usual.EndSites[bone];
        }

        return isValid ? body : new SkeletonBody(offsets, ends, body.Variant);
    }

    // False for values that are not numbers, too.
    private static bool IsValid(Vector3 position) => Math.Abs(position.X) < Farthest && Math.Abs(position.Y) < Farthest && Math.Abs(position.Z) < Farthest;
}
