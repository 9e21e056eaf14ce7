using System.Numerics;
using NeuronMocap.Gltf;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Gltf;

/// <summary>Writes the simulator's actor, and knows where his joints are.</summary>
internal static class GlbTake
{
    public const double Rate = 60;

    private static readonly SyntheticSource Actor = new(Rate);

    public static SkeletonBody Body
    {
        get
        {
            var offsets = new Vector3[BoneHierarchy.BoneCount];
            var ends = new Vector3[BoneHierarchy.BoneCount];
            Actor.GetBody(offsets, ends);
            return new SkeletonBody(offsets, ends);
        }
    }

    public static BoneTransform[] Pose(long frame)
    {
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        Actor.GetPose(frame, pose);
        return pose;
    }

    public static TimeSpan Time(long frame) => TimeSpan.FromTicks((long)Math.Round(frame * (TimeSpan.TicksPerSecond / Rate)));

    public static Vector3[] Joints(BoneTransform[] pose)
    {
        var world = new BoneTransform[pose.Length];
        ForwardKinematics.ToWorld(pose, world);
        return [.. world.Select(static joint => joint.Position / 100)];
    }

    public static void WriteFrames(GlbAvatar avatar, long count, long first = 0)
    {
        for (long frame = first; frame < first + count; frame++)
            avatar.WriteFrame(Time(frame), Pose(frame));
    }

    public static GlbFile Write(GlbOptions? options, Action<GlbWriter> write) => GlbFile.Parse(WriteBytes(options, write));

    public static byte[] WriteBytes(GlbOptions? options, Action<GlbWriter> write)
    {
        using var stream = new MemoryStream();
        using (var writer = new GlbWriter(stream, options, leaveOpen: true))
            write(writer);

        return stream.ToArray();
    }

    /// <summary>The longest distance between two sets of joints, in millimetres.</summary>
    public static float Distance(Vector3[] one, Vector3[] other) => one.Zip(other, static (a, b) => Vector3.Distance(a, b) * 1000).Max();
}
