using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

// A source whose whole motion is turned about a vertical axis. Only the values of the hips differ from the original.
internal sealed class RotatedSource(MotionSource source, BoneTransform turn) : MotionSource
{
    public override double FrameRate => source.FrameRate;

    public override long? FrameCount => source.FrameCount;

    public override bool HasDisplacement => source.HasDisplacement;

    public override SkeletonVariant Variant => source.Variant;

    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        source.GetPose(frame, pose);
        pose[(int)Bone.Hips] = turn.Apply(pose[(int)Bone.Hips]);
    }

    public override FootContacts GetFootContacts(long frame) => source.GetFootContacts(frame);

    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites) => source.GetBody(offsets, endSites);

    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
    {
        source.WriteValues(frame, layout, order, values);
        Span<float> position = values[layout.GetPositionIndex(Bone.Hips)..];
        Span<float> angles = values[layout.GetRotationIndex(Bone.Hips)..];
        BoneTransform hips = Read(position, angles, order);
        if (layout.HasReference)
        {
            // The turn is in the world. The values are relative to the reference, which does not turn.
            BoneTransform reference = Read(values, values[3..], order);
            hips = Invert(reference).Apply(turn.Apply(reference.Apply(hips)));
        }
        else
        {
            hips = turn.Apply(hips);
        }

        Write(position, hips.Position);
        Write(angles, EulerAngles.FromQuaternion(hips.Rotation, order));
    }

    private static BoneTransform Read(ReadOnlySpan<float> position, ReadOnlySpan<float> angles, RotationOrder order) => new(
        new Vector3(position[0], position[1], position[2]),
        EulerAngles.ToQuaternion(new Vector3(angles[0], angles[1], angles[2]), order));

    private static BoneTransform Invert(BoneTransform transform)
    {
        var rotation = Quaternion.Conjugate(transform.Rotation);
        return new BoneTransform(Vector3.Transform(-transform.Position, rotation), rotation);
    }
}
