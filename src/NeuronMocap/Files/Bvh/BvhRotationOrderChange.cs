namespace NeuronMocap.Bvh;

// Finds other angles for the same rotations.
internal static class BvhRotationOrderChange
{
    public static BvhDocument WithOrder(BvhDocument document, RotationOrder order)
    {
        ArgumentNullException.ThrowIfNull(document);
        BvhChannel[] rotations = BvhChannels.Rotations(order);
        BvhJointValues[] sources = document.Hierarchy.GetJointValues();
        var draft = new BvhHierarchyDraft(document.Hierarchy);
        foreach (BvhJointValues source in sources.Where(static source => source.TurnsFreely))
        {
            int next = 0;
            BvhChannel[] channels = draft[source.Joint.Index].Channels;
            draft[source.Joint.Index].Channels = [.. channels.Select(channel => channel.IsRotation() ? rotations[next++] : channel)];
        }

        BvhHierarchy hierarchy = draft.Build(out _);
        BvhJointValues[] targets = hierarchy.GetJointValues();
        float[] values = document.CopyValues(hierarchy);
        for (int joint = 0; joint < sources.Length; joint++)
        {
            if (sources[joint].TurnsFreely && sources[joint].Axes != targets[joint].Axes)
                Follow(document, sources[joint], targets[joint], values);
        }

        return document.With(hierarchy, values);
    }

    public static BvhDocument Filter(BvhDocument document)
    {
        ArgumentNullException.ThrowIfNull(document);
        float[] values = document.CopyValues();
        foreach (BvhJointValues joint in document.Hierarchy.GetJointValues().Where(joint => joint.TurnsFreely && document.FrameCount > 0))
            Filter(joint, values, document.ChannelCount, document.FrameCount);

        return document.With(document.Hierarchy, values);
    }

    // The first frame receives the smallest angles.
    private static void Follow(BvhDocument document, BvhJointValues source, BvhJointValues target, float[] values)
    {
        BvhEulerTriple near = default;
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            Span<float> row = values.AsSpan(frame * document.ChannelCount, document.ChannelCount);
            target.SetRotation(row, source.GetRotation(document.GetValues(frame)), near);
            near = target.GetAngles(row).Or(near);
        }
    }

    // Triples that are already the nearest keep their bits.
    private static void Filter(BvhJointValues joint, float[] values, int channelCount, int frameCount)
    {
        BvhEulerTriple near = joint.GetAngles(values.AsSpan(0, channelCount)).Or(default);
        for (int frame = 1; frame < frameCount; frame++)
        {
            Span<float> row = values.AsSpan(frame * channelCount, channelCount);
            joint.SetAngles(row, joint.GetAngles(row).Nearest(near));
            near = joint.GetAngles(row).Or(near);
        }
    }
}
