using System.Buffers.Binary;
using System.Numerics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap;

/// <summary>
/// A pose in at most 418 bytes, for networks and browsers: the hips' position and 59 rotations, with avatar, frame number and time. A motion packet of the
/// same rotations has 784 or 1480 bytes.
/// </summary>
/// <remarks>
/// <para>
/// A decoded rotation is within 0.01 degrees of the encoded one. The position is exact. Positions of other bones are not encoded: the receiver's
/// <see cref="SkeletonBody"/> provides them. The page docs/reference/compact-pose.md describes every byte.
/// </para>
/// <para>All members are thread-safe and allocate nothing.</para>
/// </remarks>
public static class CompactPose
{
    /// <summary>Size of the largest pose in bytes: that of an avatar whose name has 32 bytes.</summary>
    public const int MaxSize = NameOffset + ProtocolConstants.AvatarNameSize;

    private const byte Version = 1;
    private const byte HasFrameIndex = 1;
    private const byte IsSpine3 = 2;

    private const int RotationOffset = 32;
    private const int NameOffset = RotationOffset + (BoneHierarchy.BoneCount * CompactRotation.Size);

    private const long EpochTicks = 621_355_968_000_000_000;
    private const long TicksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000;

    /// <summary>Encodes a frame, with the hips in the world: the Reference node is included.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="destination">At least <see cref="MaxSize"/> bytes.</param>
    /// <param name="bytesWritten">The size of the pose; 0 if the method returns false.</param>
    /// <returns>False if the frame does not contain the 59 bones, or a value is not finite.</returns>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    /// <exception cref="InvalidOperationException">The frame is no longer valid.</exception>
    public static bool TryEncode(MotionFrame frame, Span<byte> destination, out int bytesWritten)
    {
        ArgumentNullException.ThrowIfNull(frame);
        bytesWritten = 0;
        if (!frame.HasSkeleton)
            return false;

        MotionHeader packet = frame.Header;
        var header = new CompactPoseHeader
        {
            AvatarIndex = packet.AvatarIndex,
            AvatarName = packet.AvatarName,
            FrameIndex = packet.FrameIndex,
            Time = DateTimeOffset.UtcNow - frame.Age,
            Variant = frame.Format.Variant,
        };
        Span<BoneTransform> local = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        frame.CopyLocalTransforms(local);
        if (frame.Layout.HasReference)
            local[0] = frame.GetReference().Apply(local[0]);

        return TryEncode(header, local, destination, out bytesWritten);
    }

    /// <summary>Encodes a pose.</summary>
    /// <param name="header">Whose pose it is, and when.</param>
    /// <param name="local">
    /// 59 transforms relative to the parent, in <see cref="Bone"/> order; the hips in the world, in centimetres. Rotations of any length are normalized. Only
    /// the position of the hips is used.
    /// </param>
    /// <param name="destination">At least <see cref="MaxSize"/> bytes.</param>
    /// <param name="bytesWritten">The size of the pose; 0 if the method returns false.</param>
    /// <returns>False if a value is not finite or a rotation has length zero.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms, or the destination is too short.</exception>
    public static bool TryEncode(in CompactPoseHeader header, ReadOnlySpan<BoneTransform> local, Span<byte> destination, out int bytesWritten)
    {
        ForwardKinematics.CheckPose(local, nameof(local));
        if (destination.Length < MaxSize)
            throw new ArgumentException($"There must be room for {MaxSize} bytes.", nameof(destination));

        bytesWritten = 0;
        Vector3 position = local[0].Position;
        if (!float.IsFinite(position.X) || !float.IsFinite(position.Y) || !float.IsFinite(position.Z))
            return false;

        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            if (!CompactRotation.TryWrite(destination.Slice(RotationOffset + (bone * CompactRotation.Size), CompactRotation.Size), local[bone].Rotation))
                return false;
        }

        header.AvatarName.CopyTo(destination[NameOffset..]);
        int nameSize = destination.Slice(NameOffset, ProtocolConstants.AvatarNameSize).IndexOf((byte)0);
        if (nameSize < 0)
            nameSize = ProtocolConstants.AvatarNameSize;

        destination[0] = Version;
        destination[1] = (byte)((header.FrameIndex is null ? 0 : HasFrameIndex) | (header.Variant == SkeletonVariant.Spine3 ? IsSpine3 : 0));
        destination[2] = (byte)nameSize;
        destination[3] = 0;
        BinaryPrimitives.WriteInt32LittleEndian(destination[4..], header.AvatarIndex);
        BinaryPrimitives.WriteInt64LittleEndian(destination[8..], ToMicroseconds(header.Time));
        BinaryPrimitives.WriteUInt32LittleEndian(destination[16..], header.FrameIndex ?? 0);
        BinaryPrimitives.WriteInt32LittleEndian(destination[20..], BitConverter.SingleToInt32Bits(position.X));
        BinaryPrimitives.WriteInt32LittleEndian(destination[24..], BitConverter.SingleToInt32Bits(position.Y));
        BinaryPrimitives.WriteInt32LittleEndian(destination[28..], BitConverter.SingleToInt32Bits(position.Z));
        bytesWritten = NameOffset + nameSize;
        return true;
    }

    /// <summary>Decodes a pose. Any bytes may be given: it never throws because of them.</summary>
    /// <param name="source">The bytes of one pose, without others behind it.</param>
    /// <param name="header">Whose pose it is, and when.</param>
    /// <param name="local">
    /// Receives 59 transforms relative to the parent, in <see cref="Bone"/> order; the hips in the world, in centimetres. The contents are undefined if the method
    /// returns false.
    /// </param>
    /// <param name="body">Provides the positions of the other bones. Null for the default body of the pose's variant.</param>
    /// <returns>False if the bytes are not a pose of version 1.</returns>
    /// <exception cref="ArgumentException">There is no room for 59 transforms.</exception>
    public static bool TryDecode(ReadOnlySpan<byte> source, out CompactPoseHeader header, Span<BoneTransform> local, SkeletonBody? body = null)
    {
        ForwardKinematics.CheckRoom(local, nameof(local));
        if (!TryReadHeader(source, out header))
            return false;

        ReadOnlySpan<Vector3> offsets = (body ?? SkeletonBody.GetDefault(header.Variant)).Offsets;
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            if (!CompactRotation.TryRead(source.Slice(RotationOffset + (bone * CompactRotation.Size), CompactRotation.Size), out Quaternion rotation))
                return false;

            local[bone] = new BoneTransform(offsets[bone], rotation);
        }

        var position = new Vector3(ReadSingle(source[20..]), ReadSingle(source[24..]), ReadSingle(source[28..]));
        local[0] = local[0] with { Position = position };
        return float.IsFinite(position.X) && float.IsFinite(position.Y) && float.IsFinite(position.Z);
    }

    private static bool TryReadHeader(ReadOnlySpan<byte> source, out CompactPoseHeader header)
    {
        header = default;
        if (source.Length < NameOffset || source[0] != Version || source[3] != 0)
            return false;

        byte flags = source[1];
        uint frameIndex = BinaryPrimitives.ReadUInt32LittleEndian(source[16..]);
        bool hasFrameIndex = (flags & HasFrameIndex) != 0;
        if (flags > (HasFrameIndex | IsSpine3)
            || (!hasFrameIndex && frameIndex != 0)
            || source[2] > ProtocolConstants.AvatarNameSize
            || source.Length != NameOffset + source[2]
            || source[NameOffset..].IndexOf((byte)0) >= 0
            || !TryReadTime(source, out DateTimeOffset time))
        {
            return false;
        }

        header = new CompactPoseHeader
        {
            AvatarIndex = BinaryPrimitives.ReadInt32LittleEndian(source[4..]),
            AvatarName = new AvatarName(source[NameOffset..]),
            FrameIndex = hasFrameIndex ? frameIndex : null,
            Time = time,
            Variant = (flags & IsSpine3) != 0 ? SkeletonVariant.Spine3 : SkeletonVariant.Neck1,
        };
        return true;
    }

    private static bool TryReadTime(ReadOnlySpan<byte> source, out DateTimeOffset time)
    {
        long microseconds = BinaryPrimitives.ReadInt64LittleEndian(source[8..]);
        bool isTime = microseconds >= ToMicroseconds(DateTimeOffset.MinValue) && microseconds <= ToMicroseconds(DateTimeOffset.MaxValue);
        time = isTime ? new DateTimeOffset((microseconds * TicksPerMicrosecond) + EpochTicks, TimeSpan.Zero) : default;
        return isTime;
    }

    // Before 1970 as well, the largest whole number that is not above the time.
    private static long ToMicroseconds(DateTimeOffset time) => (time.UtcTicks / TicksPerMicrosecond) - (EpochTicks / TicksPerMicrosecond);

    private static float ReadSingle(ReadOnlySpan<byte> source) => BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32LittleEndian(source));
}
