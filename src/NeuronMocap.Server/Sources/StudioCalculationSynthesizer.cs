using System.Buffers.Binary;
using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>Computes Axis Studio's calculation packets from a source (protocol.md section 9).</summary>
/// <remarks>
/// The result is a pure function of the frame number. Allocates nothing. Thread-safe.
/// <para>The payload holds for each bone, in this order:</para>
/// <list type="bullet">
/// <item>rotation of the sensor (x, y, z, w), angular velocity and acceleration, as <see cref="CalculationSynthesizer"/> computes them;</item>
/// <item>velocity and position of the bone's joint in the world, in metres per second and metres;</item>
/// <item>rotation of the bone in the world (x, y, z, w);</item>
/// <item>a 32-bit 0, which means that the sensor is not lost.</item>
/// </list>
/// <para>
/// The order and sizes of the groups come from a guide. The axes, the units other than metres, and the rotation in the world are inferred.
/// </para>
/// </remarks>
public static class StudioCalculationSynthesizer
{
    /// <summary>Bytes of the payload: 84 for each of the 59 bones.</summary>
    public const int PayloadSize = BoneHierarchy.BoneCount * BoneSize;

    private const int BoneSize = 84;
    private const int FloatsPerBone = 20;
    private const int ValuesPerBone = 16;
    private const int ContactCount = 2;
    private const float MetresPerCentimetre = 0.01f;

    /// <summary>Writes the payload of one frame.</summary>
    /// <param name="source">The source.</param>
    /// <param name="frame">Frame number, from 0, below the source's <see cref="MotionSource.FrameCount"/>.</param>
    /// <param name="payload">Exactly 4956 bytes. All of them are written.</param>
    /// <exception cref="ArgumentException">The number of bytes is wrong.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    public static void Write(MotionSource source, long frame, Span<byte> payload)
    {
        if (payload.Length != PayloadSize)
            throw new ArgumentException("The payload must have 4956 bytes.", nameof(payload));

        Span<float> sensors = stackalloc float[CalculationFrame.FullValueCount];
        CalculationSynthesizer.Write(source, frame, sensors);

        long before = Math.Max(frame - 1, 0);
        long after = Math.Min(frame + 1, (source.FrameCount ?? long.MaxValue) - 1);
        float differenceRate = after == before ? 0 : (float)source.FrameRate / (after - before);
        Span<BoneTransform> earlier = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        Span<BoneTransform> now = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        Span<BoneTransform> later = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        Sample(source, before, earlier);
        Sample(source, frame, now);
        Sample(source, after, later);

        Span<float> values = stackalloc float[FloatsPerBone];
        for (int index = 0; index < BoneHierarchy.BoneCount; index++)
        {
            int bone = (int)CalculationOrder.Bones[index];
            ReadOnlySpan<float> sensor = sensors[((index * ValuesPerBone) + (index < CalculationOrder.BodyBoneCount ? 0 : ContactCount))..];
            sensor.Slice(7, 3).CopyTo(values);
            values[3] = sensor[6];
            sensor.Slice(13, 3).CopyTo(values[4..]);
            sensor.Slice(10, 3).CopyTo(values[7..]);
            Write(values[10..], (later[bone].Position - earlier[bone].Position) * (differenceRate * MetresPerCentimetre));
            Write(values[13..], now[bone].Position * MetresPerCentimetre);
            Quaternion rotation = now[bone].Rotation;
            Write(values[16..], new Vector3(rotation.X, rotation.Y, rotation.Z));
            values[19] = rotation.W;
            WriteBone(payload.Slice(bone * BoneSize, BoneSize), values);
        }
    }

    private static void Sample(MotionSource source, long frame, Span<BoneTransform> bones)
    {
        source.GetPose(frame, bones);
        ForwardKinematics.ToWorld(bones, bones, source.Variant);
    }

    private static void WriteBone(Span<byte> target, ReadOnlySpan<float> values)
    {
        for (int i = 0; i < values.Length; i++)
            BinaryPrimitives.WriteInt32LittleEndian(target[(i * sizeof(float))..], BitConverter.SingleToInt32Bits(values[i]));

        // The sensor is not lost.
        BinaryPrimitives.WriteInt32LittleEndian(target[(values.Length * sizeof(float))..], 0);
    }

    private static void Write(Span<float> destination, Vector3 vector)
    {
        destination[0] = vector.X;
        destination[1] = vector.Y;
        destination[2] = vector.Z;
    }
}
