using NeuronMocap.Bvh;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// The input as a BVH file. A result keeps the documented rules, and a rejection names its place. Reading in pieces and strict reading agree with it.
/// </summary>
internal static class BvhTarget
{
    public static void Run(FuzzInput input)
    {
        BvhDocument document;
        try
        {
            document = BvhDocument.Parse(input.Bytes);
        }
        catch (BvhFormatException refusal)
        {
            WrongResultException.ThrowUnless(refusal.Line > 0 && refusal.Column > 0, "A refusal names no place.");
            input.Digest.Add(refusal.Message);
            BvhReading.Compare(refusal, input);
            throw;
        }

        input.Found++;
        CheckJoints(document, input);
        CheckFrames(document, input);
        CheckRepairs(document, input);
        CheckSkeleton(document, input);
        BvhReading.Compare(document, input);
        BvhReading.CompareStrict(document, input);
    }

    private static void CheckJoints(BvhDocument document, FuzzInput input)
    {
        Span<bool> isTaken = stackalloc bool[document.ChannelCount];
        isTaken.Clear();
        int channels = 0;
        for (int i = 0; i < document.Joints.Count; i++)
        {
            BvhJoint joint = document.Joints[i];
            WrongResultException.ThrowUnless(joint.Index == i && (joint.Parent?.Index ?? -1) < i, "A joint comes before its parent.");
            channels += joint.Channels.Count;
            input.Digest.Add(joint.Name);
            input.Digest.Add(joint.Offset.X + joint.Offset.Y + joint.Offset.Z + (joint.EndSite?.Y ?? 0));
            for (int channel = 0; channel < joint.Channels.Count; channel++)
            {
                ref bool isAnothers = ref isTaken[joint.FirstChannel + channel];
                WrongResultException.ThrowUnless(!isAnothers, "A joint's values are another's.");
                isAnothers = true;
                input.Digest.Add((long)joint.Channels[channel]);
            }
        }

        WrongResultException.ThrowUnless(
            document.Joints.Count is > 0 and <= BvhDocument.MaxJoints && channels == document.ChannelCount, "Joints or channels do not add up.");
    }

    private static void CheckFrames(BvhDocument document, FuzzInput input)
    {
        WrongResultException.ThrowUnless(
            double.IsFinite(document.FrameRate) && document.FrameRate > 0 && document.DeclaredFrameTime >= 0, "The rate is none.");
        input.Digest.Add(document.FrameRate);
        input.Digest.Add(document.DeclaredFrameTime);
        for (int frame = 0; frame < document.FrameCount; frame++)
            input.Digest.Add(document.GetValues(frame));
    }

    private static void CheckRepairs(BvhDocument document, FuzzInput input)
    {
        WrongResultException.ThrowUnless(
            document.Repairs.Count == Math.Min(document.RepairCount, BvhDocument.MaxListedRepairs), "The repairs do not add up.");
        for (int i = 0; i < document.Repairs.Count; i++)
        {
            WrongResultException.ThrowUnless(document.Repairs[i] is { Line: > 0, Column: > 0 }, "A repair names no place.");
            input.Digest.Add(document.Repairs[i].Description);
        }
    }

    private static void CheckSkeleton(BvhDocument document, FuzzInput input)
    {
        if (!BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason))
        {
            input.Digest.Add(reason);
            return;
        }

        Span<float> values = stackalloc float[map.Layout.ValueCount];
        Span<BoneTransform> bones = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < Math.Min(document.FrameCount, 4); frame++)
        {
            map.CopyValues(frame, values);
            map.CopyLocalTransforms(frame, bones);
            input.Digest.Add(values);
            input.Digest.Add(bones[0].Rotation.W);
        }

        input.Digest.Add((long)map.Format.RotationOrder);
        input.Digest.Add((long)map.Format.Variant);
    }
}
