using System.Numerics;

namespace NeuronMocap.Bvh;

// Adds and removes displacement.
internal static class BvhDisplacementChange
{
    public static BvhDocument Add(BvhDocument document)
    {
        ArgumentNullException.ThrowIfNull(document);
        var draft = new BvhHierarchyDraft(document.Hierarchy);
        foreach (BvhJoint joint in document.Joints)
        {
            BvhChannel[] missing = [.. BvhChannels.Positions.Except(joint.Channels)];
            draft[joint.Index].Channels = [.. missing, .. joint.Channels];
        }

        BvhHierarchy hierarchy = draft.Build(out _);
        return document.With(hierarchy, Fill(document, hierarchy, static (source, target, from, to) => target.SetPosition(to, source.GetPosition(from))));
    }

    public static BvhDocument Remove(BvhDocument document, out PositionChannelLoss loss)
    {
        ArgumentNullException.ThrowIfNull(document);
        loss = default;
        var draft = new BvhHierarchyDraft(document.Hierarchy);
        foreach (BvhJointValues joint in document.Hierarchy.GetJointValues().Where(static joint => joint.HasPosition && !IsRoot(joint.Joint)))
        {
            BvhHierarchyDraft.Joint changed = draft[joint.Joint.Index];
            changed.Channels = [.. changed.Channels.Where(static channel => !channel.IsPosition())];
            if (document.FrameCount > 0)
                changed.Offset = FindOffset(document, joint, ref loss);
        }

        BvhHierarchy hierarchy = draft.Build(out _);
        return document.With(hierarchy, Fill(document, hierarchy, static (_, _, _, _) => { }));
    }

    private static bool IsRoot(BvhJoint joint) => joint.Parent is null || BvhBoneNames.IsReference(joint.Parent);

    private static Vector3 FindOffset(BvhDocument document, BvhJointValues joint, ref PositionChannelLoss loss)
    {
        BvhPoint[] positions = new BvhPoint[document.FrameCount];
        for (int frame = 0; frame < positions.Length; frame++)
            positions[frame] = joint.GetPosition(document.GetValues(frame));

        Vector3 offset = new BvhPoint(
            Median(positions, static position => position.X),
            Median(positions, static position => position.Y),
            Median(positions, static position => position.Z)).ToVector();
        for (int frame = 0; frame < positions.Length; frame++)
        {
            double error = (positions[frame] - offset).Length;
            if (error > loss.MaxError)
                loss = new PositionChannelLoss(error, joint.Joint.Name, frame);
        }

        return offset;
    }

    // Takes one of the values, not the mean of two. Equal values then stay the same, bit for bit.
    private static double Median(BvhPoint[] positions, Func<BvhPoint, double> coordinate)
    {
        double[] values = [.. positions.Select(coordinate)];
        Array.Sort(values);
        return values[values.Length / 2];
    }

    // Copies the channels that both hierarchies have, joint by joint. The caller fills in the rest.
    private static float[] Fill(BvhDocument document, BvhHierarchy hierarchy, FillRest fillRest)
    {
        BvhJointValues[] sources = document.Hierarchy.GetJointValues();
        BvhJointValues[] targets = hierarchy.GetJointValues();
        (int From, int To)[] columns = [.. sources.Zip(targets, static (source, target) => Columns(source.Joint, target.Joint)).SelectMany(static pairs => pairs)];
        float[] values = new float[document.FrameCount * hierarchy.ChannelCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            ReadOnlySpan<float> from = document.GetValues(frame);
            Span<float> to = values.AsSpan(frame * hierarchy.ChannelCount, hierarchy.ChannelCount);
            for (int joint = 0; joint < sources.Length; joint++)
                fillRest(sources[joint], targets[joint], from, to);

            foreach ((int source, int target) in columns)
                to[target] = from[source];
        }

        return values;
    }

    // Channels are only added in front or removed. The remaining channels keep their order.
    private static List<(int From, int To)> Columns(BvhJoint source, BvhJoint target)
    {
        var columns = new List<(int From, int To)>();
        int from = source.Channels.Count;
        for (int to = target.Channels.Count - 1; to >= 0; to--)
        {
            int found = from - 1;
            while (found >= 0 && source.Channels[found] != target.Channels[to])
                found--;
            if (found < 0)
                continue;

            from = found;
            columns.Add((source.FirstChannel + found, target.FirstChannel + to));
        }

        return columns;
    }

    private delegate void FillRest(BvhJointValues source, BvhJointValues target, ReadOnlySpan<float> from, Span<float> to);
}
