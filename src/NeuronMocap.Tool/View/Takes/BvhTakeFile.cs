using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Reads BVH files of the 59 bones, row by row.</summary>
internal static class BvhTakeFile
{
    private const string UsualName = "Char00";

    /// <summary>Finds out why a file cannot be a take; null if it can.</summary>
    /// <param name="path">The file.</param>
    /// <param name="name">Its name for people.</param>
    public static string? FindFault(string path, string name)
    {
        using BvhReader reader = BvhReader.Open(path);
        return BvhSkeletonMap.TryCreate(reader.Hierarchy, out _, out string? reason) ? null : $"'{name}' is not a take of the 59 bones that Axis Neuron records. {reason}";
    }

    public static void Read(string path, TakeReading reading)
    {
        using BvhReader reader = BvhReader.Open(path);
        if (!BvhSkeletonMap.TryCreate(reader.Hierarchy, out BvhSkeletonMap? map, out string? reason))
            throw new NeuronException(reason);

        float[] row = new float[reader.Hierarchy.ChannelCount];
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        PerformerWriter? writer = null;
        while (reader.TryReadFrame(row))
        {
            map.CopyLocalTransforms(row, pose);
            writer ??= reading.Open(new AvatarName(UsualName), default, BodyOf(map, pose));
            if (map.Layout.HasReference)
                pose[0] = map.GetReference(row).Apply(pose[0]);

            // The counter is not that of a server, so no frame is missing.
            writer.Add(TimeSpan.FromTicks((long)Math.Round((reader.FrameCount - 1) * reader.FrameTime.Seconds * TimeSpan.TicksPerSecond)), null, 0, pose, null);
            reading.Report(reader.Length is > 0 and { } length ? (double)reader.BytesRead / length : 0);
        }

        if (writer is null)
        {
            reading.Open(new AvatarName(UsualName), default, map.GetBody());
            reading.AddProblem("The file holds a skeleton but no frames.");
        }

        foreach (BvhRepair repair in reader.Repairs)
            reading.AddProblem($"Line {repair.Line}, column {repair.Column}: {repair.Description}");
        if (reader.RepairCount > reader.Repairs.Count)
            reading.AddProblem($"{reader.RepairCount - reader.Repairs.Count} more defects were read as well as possible.");
    }

    // With position channels, the first pose has the lengths: some programs write zeros as OFFSETs.
    private static SkeletonBody BodyOf(BvhSkeletonMap map, ReadOnlySpan<BoneTransform> pose) =>
        map.Layout.HasDisplacement ? SkeletonBody.FromPose(pose, map.Format.Variant, map.GetBody().EndSites) : map.GetBody();
}
