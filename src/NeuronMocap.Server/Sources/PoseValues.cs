using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

// Converts between the values of a motion packet and transforms.
internal static class PoseValues
{
    private const int ReferenceRotation = 3;

    public static void Write(Span<float> values, ChannelLayout layout, RotationOrder order, Bone bone, BoneTransform transform)
    {
        int position = layout.GetPositionIndex(bone);
        if (position >= 0)
            Write(values[position..], transform.Position);

        Write(values[layout.GetRotationIndex(bone)..], EulerAngles.FromQuaternion(transform.Rotation, order));
    }

    public static void WriteReference(Span<float> values, RotationOrder order, BoneTransform reference)
    {
        Write(values, reference.Position);
        Write(values[ReferenceRotation..], EulerAngles.FromQuaternion(reference.Rotation, order));
    }

    // If the values have no position, the offsets give it.
    public static BoneTransform Read(ReadOnlySpan<float> values, ChannelLayout layout, RotationOrder order, Bone bone, ReadOnlySpan<Vector3> offsets)
    {
        int position = layout.GetPositionIndex(bone);
        return new BoneTransform(
            position < 0 ? offsets[(int)bone] : ReadVector(values[position..]),
            EulerAngles.ToQuaternion(ReadVector(values[layout.GetRotationIndex(bone)..]), order));
    }

    public static BoneTransform ReadReference(ReadOnlySpan<float> values, ChannelLayout layout, RotationOrder order) => layout.HasReference
        ? new BoneTransform(ReadVector(values), EulerAngles.ToQuaternion(ReadVector(values[ReferenceRotation..]), order))
        : BoneTransform.Identity;

    private static Vector3 ReadVector(ReadOnlySpan<float> values) => new(values[0], values[1], values[2]);

    private static void Write(Span<float> destination, Vector3 vector)
    {
        destination[0] = vector.X;
        destination[1] = vector.Y;
        destination[2] = vector.Z;
    }
}
