using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Compares two takes to the last bit.</summary>
internal static class TakeComparison
{
    public static void AssertSame(BvhDocument expected, BvhDocument actual)
    {
        Assert.Equal(
            expected.Joints.Select(static joint => (joint.Name, joint.Parent?.Name, joint.Offset, joint.EndSite)),
            actual.Joints.Select(static joint => (joint.Name, joint.Parent?.Name, joint.Offset, joint.EndSite)));
        Assert.Equal(expected.Joints.SelectMany(static joint => joint.Channels), actual.Joints.SelectMany(static joint => joint.Channels));
        Assert.Equal(expected.FrameTime, actual.FrameTime);
        Assert.Equal(Bits(Values(expected)), Bits(Values(actual)));
    }

    public static void AssertSame(CalculationDocument expected, CalculationDocument actual)
    {
        Assert.Equal(expected.FrameCount, actual.FrameCount);
        for (int row = 0; row < expected.FrameCount; row++)
            Assert.Equal(Bits(expected.GetValues(row).ToArray()), Bits(actual.GetValues(row).ToArray()));
    }

    public static void AssertSamePoses(BvhDocument expected, BvhDocument actual, Func<int, int> frameOf)
    {
        Assert.True(BvhSkeletonMap.TryCreate(expected, out BvhSkeletonMap? expectedMap, out _));
        Assert.True(BvhSkeletonMap.TryCreate(actual, out BvhSkeletonMap? actualMap, out _));
        BoneTransform[] from = new BoneTransform[BoneHierarchy.BoneCount];
        BoneTransform[] to = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < actual.FrameCount; frame++)
        {
            expectedMap.CopyLocalTransforms(frameOf(frame), from);
            actualMap.CopyLocalTransforms(frame, to);
            for (int bone = 0; bone < from.Length; bone++)
            {
                Assert.Equal(from[bone].Position, to[bone].Position);
                Assert.InRange(MathF.Abs(Quaternion.Dot(from[bone].Rotation, to[bone].Rotation)), 0.999999f, 1.000001f);
            }
        }
    }

    public static void AssertSameFrames(string expected, string actual)
    {
        List<(TimeSpan Time, uint? Index, int[] Values)> first = Frames(expected);
        List<(TimeSpan Time, uint? Index, int[] Values)> second = Frames(actual);
        Assert.Equal(first.Select(static frame => (frame.Time, frame.Index)), second.Select(static frame => (frame.Time, frame.Index)));
        Assert.Equal(first.SelectMany(static frame => frame.Values), second.SelectMany(static frame => frame.Values));
    }

    public static List<TimeSpan> Times(string path) => [.. Frames(path).Select(static frame => frame.Time)];

    public static Vector3[][] Joints(BvhDocument document)
    {
        Assert.True(BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out _));
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        return
        [
            .. Enumerable.Range(0, document.FrameCount).Select(frame =>
            {
                map.CopyLocalTransforms(frame, pose);
                ForwardKinematics.ToWorld(pose, pose, map.Format.Variant);
                return pose.Select(static bone => bone.Position).ToArray();
            }),
        ];
    }

    public static float[] Values(BvhDocument document) => [.. Enumerable.Range(0, document.FrameCount).SelectMany(frame => Row(document, frame))];

    public static float[] Row(BvhDocument document, int frame) => document.GetValues(frame).ToArray();

    private static List<(TimeSpan Time, uint? Index, int[] Values)> Frames(string path)
    {
        var frames = new List<(TimeSpan, uint?, int[])>();
        using RecordedFrameReader reader = RecordedFrameReader.Open(path);
        while (reader.Read())
        {
            float[] values = reader.Frame is MotionFrame motion ? motion.Values.ToArray() : ((CalculationFrame)reader.Frame).Values.ToArray();
            frames.Add((reader.Time, reader.Frame.FrameIndex, Bits(values)));
        }

        return frames;
    }

    private static int[] Bits(IEnumerable<float> values) => [.. values.Select(BitConverter.SingleToInt32Bits)];
}
