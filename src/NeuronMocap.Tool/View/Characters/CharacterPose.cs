using System.Buffers.Binary;
using System.Numerics;
using NeuronMocap.Frames;
using NeuronMocap.Retargeting;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>
/// A pose of a character as the page receives it. It has the hips' position and the rotation of each bone, as values for the nodes of the
/// character's file. Little endian. Thread-safe.
/// </summary>
internal static class CharacterPose
{
    /// <summary>Size of the largest pose in bytes.</summary>
    public const int MaxSize = HeaderSize + (BoneCount * CompactRotation.Size);

    private const int BoneCount = Skeleton.BoneHierarchy.BoneCount;
    private const int HeaderSize = 28;
    private const byte Version = 1;
    private const byte Kind = 2;

    /// <summary>Gets the size of a character's poses.</summary>
    public static int SizeOf(CharacterRig rig) => HeaderSize + (rig.Bones.Length * CompactRotation.Size);

    /// <summary>Encodes a pose.</summary>
    /// <param name="rig">The character.</param>
    /// <param name="pose">Its pose.</param>
    /// <param name="character">Number of the character.</param>
    /// <param name="microseconds">The time of the frame: live since 1970 in UTC, otherwise since the start of the take.</param>
    /// <param name="destination">At least <see cref="MaxSize"/> bytes.</param>
    /// <returns>The size of the pose.</returns>
    public static int Encode(CharacterRig rig, RetargetedPose pose, uint character, long microseconds, Span<byte> destination)
    {
        ReadOnlySpan<CharacterBone> bones = rig.Bones;
        destination[0] = Version;
        destination[1] = Kind;
        BinaryPrimitives.WriteUInt16LittleEndian(destination[2..], (ushort)bones.Length);
        BinaryPrimitives.WriteUInt32LittleEndian(destination[4..], character);
        BinaryPrimitives.WriteInt64LittleEndian(destination[8..], microseconds);
        Vector3 hips = GltfAxes.FromRig(pose.HipsLocalPosition);
        BinaryPrimitives.WriteSingleLittleEndian(destination[16..], hips.X);
        BinaryPrimitives.WriteSingleLittleEndian(destination[20..], hips.Y);
        BinaryPrimitives.WriteSingleLittleEndian(destination[24..], hips.Z);
        int end = HeaderSize;
        foreach (CharacterBone bone in bones)
        {
            CompactRotation.TryWrite(destination[end..], GltfAxes.FromRig(pose.LocalRotations[bone.Node]));
            end += CompactRotation.Size;
        }

        return end;
    }
}
