using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Compact poses with names of different lengths.</summary>
internal static class PoseFixtures
{
    /// <summary>Words of a rotation at their limits, numbers that are not finite, and times out of range.</summary>
    public static IReadOnlyList<byte[]> Words { get; } =
    [
        [0x00, 0xC0, 0x00, 0xC0, 0x00, 0x40], [0xFF, 0x7F], [0x00, 0x80], [0x00, 0x00], [0xFF, 0xFF], [0x01, 0x40], [0xFF, 0x3F],
        [0, 0, 0x80, 0x7F], [0, 0, 0xC0, 0xFF], [0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F], [0, 0, 0, 0, 0, 0, 0, 0x80],
    ];

    public static IReadOnlyList<byte[]> Create() => [Pose(""), Pose("Char00"), Pose("演员一"), Pose(new string('x', 32))];

    private static byte[] Pose(string name)
    {
        byte[] bytes = new byte[CompactPose.MaxSize];
        BoneTransform[] pose = [.. Enumerable.Range(0, BoneHierarchy.BoneCount).Select(Turn)];
        var header = new CompactPoseHeader { AvatarName = new AvatarName(name), FrameIndex = name.Length == 0 ? null : 41, Time = DateTimeOffset.UnixEpoch };
        CompactPose.TryEncode(header, pose, bytes, out int size);
        return bytes[..size];
    }

    private static BoneTransform Turn(int bone) =>
        new(new Vector3(bone, 90, -bone), Quaternion.CreateFromYawPitchRoll(bone / 10f, bone / 20f, -bone / 7f));
}
