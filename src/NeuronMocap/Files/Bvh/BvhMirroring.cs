using System.Numerics;

namespace NeuronMocap.Bvh;

// A reflection in X leaves a rotation about X unchanged and inverts a rotation about Y or Z. The same applies to each angle of a row, in any
// rotation order. Rotations therefore do not have to be decomposed.
internal static class BvhMirroring
{
    public static BvhDocument Mirror(BvhDocument document)
    {
        ArgumentNullException.ThrowIfNull(document);
        int[] partners = BvhSides.FindPartners(document.Hierarchy);
        IReadOnlyList<BvhJoint> joints = document.Joints;
        var draft = new BvhHierarchyDraft(document.Hierarchy);
        for (int joint = 0; joint < partners.Length; joint++)
        {
            BvhJoint partner = joints[partners[joint]];
            draft[joint].Offset = Mirror(partner.Offset);
            draft[joint].EndSite = partner.EndSite is { } end ? Mirror(end) : null;
            draft[joint].Channels = [.. partner.Channels];
        }

        BvhHierarchy hierarchy = draft.Build(out _);
        return document.With(hierarchy, Mirror(document, hierarchy, partners));
    }

    private static float[] Mirror(BvhDocument document, BvhHierarchy hierarchy, int[] partners)
    {
        float[] values = new float[document.FrameCount * document.ChannelCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            ReadOnlySpan<float> from = document.GetValues(frame);
            Span<float> to = values.AsSpan(frame * document.ChannelCount, document.ChannelCount);
            foreach (BvhJoint joint in hierarchy.Joints)
            {
                int partner = document.Joints[partners[joint.Index]].FirstChannel;
                for (int i = 0; i < joint.Channels.Count; i++)
                    to[joint.FirstChannel + i] = Changes(joint.Channels[i]) ? Opposite(from[partner + i]) : from[partner + i];
            }
        }

        return values;
    }

    private static bool Changes(BvhChannel channel) => channel is BvhChannel.Xposition or BvhChannel.Yrotation or BvhChannel.Zrotation;

    private static Vector3 Mirror(Vector3 offset) => offset with { X = Opposite(offset.X) };

    // Zero keeps its sign, because a file with -0 is harder to read. NaN remains NaN.
    private static float Opposite(float value) => value == 0 ? value : -value;
}
