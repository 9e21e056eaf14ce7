using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Convert;

/// <summary>Writes a take as a BVH file.</summary>
internal static class BvhOutput
{
    public static void Write(
        MotionSource take, ChannelLayout layout, RotationOrder order, Stream output, IProgress<double> progress, CancellationToken cancellationToken)
    {
        Vector3[] offsets = new Vector3[BoneHierarchy.BoneCount];
        Vector3[] endSites = new Vector3[BoneHierarchy.BoneCount];
        take.GetBody(offsets, endSites);
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(
            new SkeletonFormat(order, take.Variant), layout, new SkeletonBody(offsets, endSites, take.Variant));
        using var writer = new BvhWriter(output, hierarchy, BvhFrameTime.FromFrameRate(take.FrameRate));
        float[] values = new float[layout.ValueCount];
        long count = take.FrameCount!.Value;
        for (long frame = 0; frame < count; frame++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            take.WriteValues(frame, layout, order, values);
            writer.WriteFrame(values);
            progress.Report((double)frame / count);
        }
    }
}
