using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

// Converts between the two namings of spine and neck. The shoulders are children of Spine2 in one, and of the bone above it in the other.
internal static class BvhVariantChange
{
    // Below the resolution of a float at the length of an arm.
    private const double SamePlace = 1e-5;

    private const Bone Above = Bone.Neck;

    private static readonly Bone[] Shoulders = [Bone.RightShoulder, Bone.LeftShoulder];

    public static BvhDocument Change(BvhDocument document, SkeletonVariant variant)
    {
        BvhSkeletonMap map = FindBones(document);
        if (map.Format.Variant == variant)
            return document;

        if (!map.Layout.HasDisplacement && Turns(map))
            map = FindBones(document.WithDisplacement());

        var draft = new BvhHierarchyDraft(map.Document.Hierarchy);
        Rename(draft, map, variant);
        foreach (Bone shoulder in Shoulders)
        {
            BvhHierarchyDraft.Joint joint = draft[map[shoulder].Index];
            joint.Parent = map[BoneHierarchy.GetParent(shoulder, variant)!.Value].Index;
            joint.Offset = variant == SkeletonVariant.Spine3 ? joint.Offset - map[Above].Offset : joint.Offset + map[Above].Offset;
        }

        BvhHierarchy hierarchy = draft.Build(out int[] places);
        return document.With(hierarchy, Move(map, hierarchy, places, variant));
    }

    private static BvhSkeletonMap FindBones(BvhDocument document) =>
        BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason)
            ? map
            : throw new NeuronException($"The file does not have the skeleton of 59 bones. {reason}");

    private static void Rename(BvhHierarchyDraft draft, BvhSkeletonMap map, SkeletonVariant variant)
    {
        foreach (Bone bone in (Bone[])[Bone.Neck, Bone.Neck1])
        {
            string prefix = map[bone].Name[..^BoneHierarchy.GetName(bone, map.Format.Variant).Length];
            draft[map[bone].Index].Name = prefix + BoneHierarchy.GetName(bone, variant);
        }
    }

    // Returns whether a shoulder that is fixed to one bone moves relative to the other.
    private static bool Turns(BvhSkeletonMap map)
    {
        var above = new BvhJointValues(map[Above]);
        for (int frame = 0; frame < map.Document.FrameCount; frame++)
        {
            BvhRotation rotation = above.GetRotation(map.Document.GetValues(frame));
            foreach (Bone shoulder in Shoulders)
            {
                BvhPoint offset = map[shoulder].Offset;
                BvhPoint lever = map.Format.Variant == SkeletonVariant.Spine3 ? offset : offset - map[Above].Offset;
                if ((rotation.Turn(lever) - lever).Length > SamePlace)
                    return true;
            }
        }

        return false;
    }

    private static float[] Move(BvhSkeletonMap map, BvhHierarchy hierarchy, int[] places, SkeletonVariant variant)
    {
        BvhDocument document = map.Document;
        var above = new BvhJointValues(map[Above]);
        (BvhJointValues Source, BvhJointValues Target)[] shoulders =
        [
            .. Shoulders.Select(bone => (new BvhJointValues(map[bone]), new BvhJointValues(hierarchy.Joints[places[map[bone].Index]]))),
        ];
        BvhEulerTriple[] near = new BvhEulerTriple[shoulders.Length];
        float[] values = new float[document.FrameCount * document.ChannelCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            ReadOnlySpan<float> from = document.GetValues(frame);
            Span<float> to = values.AsSpan(frame * document.ChannelCount, document.ChannelCount);
            foreach (BvhJoint joint in document.Joints)
                from.Slice(joint.FirstChannel, joint.Channels.Count).CopyTo(to[hierarchy.Joints[places[joint.Index]].FirstChannel..]);

            for (int i = 0; i < shoulders.Length; i++)
            {
                (BvhJointValues source, BvhJointValues target) = shoulders[i];
                (BvhPoint position, BvhRotation rotation) = Move(source, above, from, isUp: variant == SkeletonVariant.Spine3);
                target.SetPosition(to, position);
                target.SetRotation(to, rotation, frame == 0 ? source.GetAngles(from) : near[i]);
                near[i] = target.GetAngles(to).Or(near[i]);
            }
        }

        return values;
    }

    // Expresses the shoulder relative to the bone above, or relative to that bone's parent.
    private static (BvhPoint Position, BvhRotation Rotation) Move(BvhJointValues shoulder, BvhJointValues above, ReadOnlySpan<float> row, bool isUp)
    {
        BvhPoint position = shoulder.GetPosition(row);
        BvhRotation rotation = shoulder.GetRotation(row);
        BvhRotation turn = above.GetRotation(row);
        return isUp
            ? (turn.Inverse.Turn(position - above.GetPosition(row)), turn.Inverse * rotation)
            : (above.GetPosition(row) + turn.Turn(position), turn * rotation);
    }
}
