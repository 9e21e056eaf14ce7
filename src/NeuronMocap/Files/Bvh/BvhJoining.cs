using NeuronMocap.Protocol;

namespace NeuronMocap.Bvh;

// Joins takes, one after the other.
internal static class BvhJoining
{
    public static BvhDocument Join(IReadOnlyList<BvhDocument> takes, bool align)
    {
        ArgumentNullException.ThrowIfNull(takes);
        if (takes.Count == 0 || takes.Contains(null!))
            throw new ArgumentException("At least one take is needed, and none may be null.", nameof(takes));

        BvhDocument first = takes[0];
        for (int i = 1; i < takes.Count; i++)
        {
            if (FindDifference(first, takes[i]) is { } difference)
                throw new NeuronException($"Take {i + 1} cannot follow take 1: {difference}");
        }

        int channelCount = first.ChannelCount;
        long count = takes.Sum(static take => (long)take.FrameCount);
        if (count * channelCount > int.MaxValue)
            throw new ArgumentException($"The result has {count} frames, more than a document can have.", nameof(takes));

        float[] values = new float[(int)count * channelCount];
        int end = 0;
        foreach (BvhDocument take in takes)
        {
            int start = end;
            for (int frame = 0; frame < take.FrameCount; frame++, end++)
                take.GetValues(frame).CopyTo(values.AsSpan(end * channelCount));

            if (align && start > 0 && end > start)
                new BvhAlignment(first.Hierarchy).Align(values, start, end);
        }

        return first.With(first.Hierarchy, values);
    }

    private static string? FindDifference(BvhDocument first, BvhDocument next)
    {
        if (next.Joints.Count != first.Joints.Count)
            return $"it has {CountedNoun.Of(next.Joints.Count, "joint")} instead of {first.Joints.Count}.";

        for (int i = 0; i < first.Joints.Count; i++)
        {
            if (FindDifference(first.Joints[i], next.Joints[i]) is { } difference)
                return difference;
        }

        return next.FrameTime == first.FrameTime ? null : $"its frame time is {next.FrameTime} s instead of {first.FrameTime} s. Resample it.";
    }

    private static string? FindDifference(BvhJoint first, BvhJoint next)
    {
        if (!string.Equals(next.Name, first.Name, StringComparison.Ordinal))
            return $"joint {next.Index + 1} is {next.Name} instead of {first.Name}.";
        if (next.Parent?.Index != first.Parent?.Index)
            return $"{next.Name} is a child of {next.Parent?.Name ?? "nothing"} instead of {first.Parent?.Name ?? "nothing"}.";
        if (!next.Channels.SequenceEqual(first.Channels) || next.FirstChannel != first.FirstChannel)
            return $"{next.Name} has the channels {string.Join(' ', next.Channels)} instead of {string.Join(' ', first.Channels)}.";

        bool isReplaced = new BvhJointValues(next).MovesFreely;
        return isReplaced || next.Offset == first.Offset ? null : $"the OFFSET of {next.Name} is {next.Offset} instead of {first.Offset}. The takes have different bodies.";
    }
}
