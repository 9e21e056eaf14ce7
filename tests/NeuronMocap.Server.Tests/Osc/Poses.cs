using System.Numerics;
using NeuronMocap.Server.Osc;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Tests.Osc;

/// <summary>Frames with random poses, and their encoding.</summary>
internal static class Poses
{
    public static MotionFrame Frame(int seed = 1, int avatar = 0, string name = "Ann", int count = 360, SkeletonVariant variant = SkeletonVariant.Neck1)
    {
        var random = new Random(seed);
        var header = new MotionHeader { HasDisplacement = count >= 354, HasReference = count is 186 or 360, AvatarIndex = avatar, AvatarName = new AvatarName(name), FrameIndex = (uint)seed };
        return new MotionFrame(header, [.. Enumerable.Range(0, count).Select(_ => (random.NextSingle() * 360) - 180)], new SkeletonFormat(RotationOrder.YXZ, variant));
    }

    public static AvatarPose Taken(MotionFrame frame)
    {
        var pose = new AvatarPose(0, frame.AvatarIndex);
        pose.Take(frame);
        return pose;
    }

    /// <summary>The datagrams of a pose.</summary>
    public static List<byte[]> Encode(IPoseEncoder encoder, AvatarPose pose, int maxSize = 1400)
    {
        List<byte[]> datagrams = [];
        Assert.True(encoder.TryEncode(pose, new OscBundle(maxSize, (bytes, length) => datagrams.Add(bytes[..length]))));
        return datagrams;
    }

    public static OscMessage[] Decode(IEnumerable<byte[]> datagrams) => [.. datagrams.SelectMany(OscMessage.ReadBundle)];

    public static BoneTransform TransformOf(OscMessage message)
    {
        int first = message.Arguments.Length - 7;
        return new BoneTransform(
            new Vector3(message.Float(first), message.Float(first + 1), message.Float(first + 2)),
            new Quaternion(message.Float(first + 3), message.Float(first + 4), message.Float(first + 5), message.Float(first + 6)));
    }

    public static BoneTransform[] World(MotionFrame frame)
    {
        BoneTransform[] world = new BoneTransform[BoneHierarchy.BoneCount];
        frame.CopyWorldTransforms(world);
        return world;
    }

    /// <summary>Asserts the same place and the same rotation, by either of its quaternions.</summary>
    public static void AssertSame(BoneTransform expected, BoneTransform actual, float tolerance, string what)
    {
        float distance = Vector3.Distance(expected.Position, actual.Position);
        float cosine = Math.Abs(Quaternion.Dot(expected.Rotation, actual.Rotation));
        Assert.True(distance <= tolerance, $"{what} is at {actual.Position} and not at {expected.Position}.");
        Assert.True(cosine > 0.99999f && Math.Abs(actual.Rotation.Length() - 1) < 1e-5f, $"{what} has the rotation {actual.Rotation} and not {expected.Rotation}.");
    }
}
