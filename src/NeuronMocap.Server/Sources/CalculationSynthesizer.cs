using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// Computes the values of a calculation packet from a source, as sensors would have measured them (manual section 1.2.2, protocol.md section 3.3).
/// </summary>
/// <remarks>
/// The result is a pure function of the frame number. Allocates nothing. Thread-safe.
/// <para>
/// The world's axes are those of the BVH stream: right-handed, Y up, X to the subject's left at rest, Z forward. On a real server the axes are a
/// setting. In files that Axis Neuron exports, Z points down.
/// </para>
/// <para>
/// Positions are in metres. The position of a bone is the middle between its joint and the next joint of its chain, or its End Site. End Sites are
/// those of the default body. The next joint after a hand is that of the middle finger. The position of the hips is their joint, as in recordings.
/// Velocities are in metres per second. The quaternion is the rotation of the bone in the world, as from a sensor aligned with the bone.
/// </para>
/// <para>
/// Acceleration and angular velocity are in the axes of the bone. The manual does not give their units; the units here follow recordings. The
/// acceleration is gravity minus the acceleration of the bone's centre, in multiples of 9.80665 m/s². At rest it is 1 downwards: the
/// measurement of an accelerometer with its sign changed. The angular velocity is in radians per second.
/// </para>
/// <para>
/// Derivatives come from a frame and its two neighbours. If a neighbour does not exist, velocity and angular velocity are one-sided differences, and
/// the acceleration is that of the existing neighbour. A source with one frame is at rest. A source with two frames has no acceleration.
/// </para>
/// </remarks>
public static class CalculationSynthesizer
{
    private const int Window = 3;
    private const int ValuesPerBone = 16;
    private const int ContactCount = 2;
    private const int Bones = BoneHierarchy.BoneCount;
    private const float MetresPerCentimetre = 0.01f;
    private const float StandardGravity = 9.80665f;

    /// <summary>Writes the values of one frame.</summary>
    /// <param name="source">The source.</param>
    /// <param name="frame">Frame number, from 0, below the source's <see cref="MotionSource.FrameCount"/>.</param>
    /// <param name="values">
    /// Exactly 946 values for 59 bones (<see cref="CalculationFrame.FullValueCount"/>) or 338 for 21 (<see cref="CalculationFrame.BodyValueCount"/>).
    /// All of them are written.
    /// </param>
    /// <exception cref="ArgumentException">The number of values is wrong.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    public static void Write(MotionSource source, long frame, Span<float> values)
    {
        if (values.Length is not (CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount))
            throw new ArgumentException("A frame must have 946 or 338 values.", nameof(values));

        long last = (source.FrameCount ?? long.MaxValue) - 1;
        if (frame < 0 || frame > last)
            throw new ArgumentOutOfRangeException(nameof(frame), frame, "The frame number must be at least 0 and less than the source's number of frames.");

        long first = Math.Max(0, Math.Min(frame - 1, last - (Window - 1)));
        int count = (int)Math.Min(Window, last - first + 1);
        Span<BoneTransform> samples = stackalloc BoneTransform[Window * Bones];
        for (int i = 0; i < count; i++)
            Sample(source, first + i, samples.Slice(i * Bones, Bones));

        int at = (int)(frame - first);
        int before = Math.Max(at - 1, 0);
        int after = Math.Min(at + 1, count - 1);
        float rate = (float)source.FrameRate;
        float differenceRate = after == before ? 0 : rate / (after - before);
        float secondDifferenceRate = count == Window ? rate * rate : 0;

        int boneCount = (values.Length - ContactCount) / ValuesPerBone;
        for (int index = 0; index < boneCount; index++)
        {
            int bone = (int)CalculationOrder.Bones[index];
            BoneTransform now = samples[(at * Bones) + bone];
            BoneTransform earlier = samples[(before * Bones) + bone];
            BoneTransform later = samples[(after * Bones) + bone];
            Vector3 secondDifference =
                samples[bone].Position - (2 * samples[Bones + bone].Position) + samples[(2 * Bones) + bone].Position;

            int offset = (index * ValuesPerBone) + (index < CalculationOrder.BodyBoneCount ? 0 : ContactCount);
            Span<float> target = values.Slice(offset, ValuesPerBone);
            Write(target, now.Position);
            Write(target[3..], (later.Position - earlier.Position) * differenceRate);
            target[6] = now.Rotation.W;
            Write(target[7..], new Vector3(now.Rotation.X, now.Rotation.Y, now.Rotation.Z));
            Write(target[10..], Sense(secondDifference * secondDifferenceRate, now.Rotation));
            Write(target[13..], RotationVector(earlier.Rotation, later.Rotation) * differenceRate);
        }

        (bool left, bool right) = source.GetFootContacts(frame);
        Span<float> contacts = values.Slice(CalculationOrder.BodyBoneCount * ValuesPerBone, ContactCount);
        contacts[0] = left ? 1 : 0;
        contacts[1] = right ? 1 : 0;
    }

    // Writes centres in metres and rotations, in the world.
    private static void Sample(MotionSource source, long frame, Span<BoneTransform> bones)
    {
        source.GetPose(frame, bones);
        ForwardKinematics.ToWorld(bones, bones, source.Variant);

        // A bone's position is replaced by its centre only when no other bone needs it any more. Parents come before their children.
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            BoneTransform world = bones[(int)bone];
            bones[(int)bone] = world with { Position = (world.Position + End(bone, bones)) * (MetresPerCentimetre / 2) };
        }
    }

    private static Vector3 End(Bone bone, ReadOnlySpan<BoneTransform> world)
    {
        if (DefaultOffsets.TryGetEndSite(bone, out Vector3 end))
            return world[(int)bone].TransformPoint(end);

        return bone switch
        {
            Bone.Hips => world[(int)bone].Position,
            Bone.RightHand => world[(int)Bone.RightInHandMiddle].Position,
            Bone.LeftHand => world[(int)Bone.LeftInHandMiddle].Position,
            _ => world[(int)bone + 1].Position,
        };
    }

    private static Vector3 Sense(Vector3 acceleration, Quaternion rotation) =>
        Vector3.Transform(-Vector3.UnitY - (acceleration / StandardGravity), Quaternion.Conjugate(rotation));

    // Returns the shorter turn from one rotation to another. The axis is in the body's own axes; the length is in radians.
    private static Vector3 RotationVector(Quaternion from, Quaternion to)
    {
        Quaternion turn = Quaternion.Conjugate(from) * to;
        var axis = new Vector3(turn.X, turn.Y, turn.Z);
        float sine = axis.Length();
        if (sine == 0)
            return Vector3.Zero;

        float sign = turn.W < 0 ? -1 : 1;
        return axis * (sign * 2 * MathF.Atan2(sine, sign * turn.W) / sine);
    }

    private static void Write(Span<float> destination, Vector3 vector)
    {
        destination[0] = vector.X;
        destination[1] = vector.Y;
        destination[2] = vector.Z;
    }
}
