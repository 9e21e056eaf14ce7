using System.Numerics;

namespace NeuronMocap.Motion;

/// <summary>
/// Interpolates poses between frames. Does not allocate memory. Thread-safe.
/// </summary>
/// <remarks>
/// Use transforms relative to the parents: in the world, bones would change their lengths in between. Of the two quaternions of a rotation, the
/// nearer one is used, so a bone takes the shorter rotation. A pose is a span with any number of transforms.
/// </remarks>
public static class PoseInterpolation
{
    // Above 50 degrees between two frames, smooth motion cannot be reconstructed.
    private const float MinCosine = 0.9f;

    /// <summary>Interpolates between two frames: positions along a straight line, rotations at a constant speed.</summary>
    /// <param name="from">The pose at part 0.</param>
    /// <param name="to">The pose at part 1.</param>
    /// <param name="part">The fraction of the interval, 0 to 1. Values outside this range extrapolate the motion.</param>
    /// <param name="pose">Receives as many transforms as <paramref name="from"/> has. It may be the memory of an input pose.</param>
    /// <exception cref="ArgumentException">The second pose has fewer transforms, or the destination is too short.</exception>
    public static void Linear(ReadOnlySpan<BoneTransform> from, ReadOnlySpan<BoneTransform> to, double part, Span<BoneTransform> pose)
    {
        Check(from, to, pose);
        float amount = (float)part;
        for (int i = 0; i < from.Length; i++)
        {
            pose[i] = new BoneTransform(
                Vector3.Lerp(from[i].Position, to[i].Position, amount), QuaternionMath.Slerp(from[i].Rotation, to[i].Rotation, amount));
        }
    }

    /// <summary>
    /// Interpolates between the second and the third of four frames. The velocity does not jump at frames. A bone that turns more than 50 degrees
    /// between two frames turns at a constant speed.
    /// </summary>
    /// <param name="frames">The four poses.</param>
    /// <param name="seconds">The requested time, between the times of the second and the third frame.</param>
    /// <param name="pose">Receives as many transforms as the second pose has.</param>
    /// <exception cref="ArgumentException">
    /// A pose has fewer transforms than the second, the destination is too small, or the times do not ascend.
    /// </exception>
    public static void Cubic(in CubicPoseWindow frames, double seconds, Span<BoneTransform> pose)
    {
        ReadOnlySpan<BoneTransform> before = frames.First.IsEmpty ? frames.Second : frames.First;
        ReadOnlySpan<BoneTransform> after = frames.Fourth.IsEmpty ? frames.Third : frames.Fourth;
        Check(frames.Second, before, pose);
        Check(frames.Second, frames.Third, pose);
        Check(frames.Second, after, pose);
        var weights = new CubicWeights(
            frames.First.IsEmpty ? double.NegativeInfinity : frames.Times.First,
            frames.Times.Second,
            frames.Times.Third,
            frames.Fourth.IsEmpty ? double.PositiveInfinity : frames.Times.Fourth,
            seconds);
        for (int i = 0; i < frames.Second.Length; i++)
        {
            Quaternion second = frames.Second[i].Rotation;
            Quaternion first = QuaternionMath.InHemisphereOf(second, before[i].Rotation);
            Quaternion third = QuaternionMath.InHemisphereOf(second, frames.Third[i].Rotation);
            Quaternion fourth = QuaternionMath.InHemisphereOf(third, after[i].Rotation);
            bool smooth = Quaternion.Dot(first, second) > MinCosine
                && Quaternion.Dot(second, third) > MinCosine
                && Quaternion.Dot(third, fourth) > MinCosine;
            pose[i] = new BoneTransform(
                (before[i].Position * weights.First)
                    + (frames.Second[i].Position * weights.Second)
                    + (frames.Third[i].Position * weights.Third)
                    + (after[i].Position * weights.Fourth),
                smooth
                    ? Quaternion.Normalize((first * weights.First) + (second * weights.Second) + (third * weights.Third) + (fourth * weights.Fourth))
                    : QuaternionMath.Slerp(second, third, weights.Part));
        }
    }

    /// <summary>
    /// Selects one of the two quaternions of every rotation: the one nearer to the previous frame. The rotations do not change. The numbers can
    /// then be compared, averaged, filtered or interpolated one by one.
    /// </summary>
    /// <param name="before">The previous frame, which is already continuous.</param>
    /// <param name="pose">The frame, which is changed in place.</param>
    /// <exception cref="ArgumentException">The previous frame has fewer transforms.</exception>
    public static void MakeContinuous(ReadOnlySpan<BoneTransform> before, Span<BoneTransform> pose)
    {
        Check(pose, before, pose);
        for (int i = 0; i < pose.Length; i++)
            pose[i] = pose[i] with { Rotation = QuaternionMath.InHemisphereOf(before[i].Rotation, pose[i].Rotation) };
    }

    private static void Check(ReadOnlySpan<BoneTransform> pose, ReadOnlySpan<BoneTransform> other, Span<BoneTransform> destination)
    {
        if (other.Length < pose.Length)
            throw new ArgumentException("The neighbouring pose has fewer transforms.", nameof(other));
        if (destination.Length < pose.Length)
            throw new ArgumentException("There must be room for each transform.", nameof(destination));
    }
}
