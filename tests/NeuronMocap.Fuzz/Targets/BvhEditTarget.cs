using NeuronMocap.Bvh;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// The input as a BVH file that is changed in every possible way. Each result is a take that can be written, and reads back as the same take.
/// </summary>
internal static class BvhEditTarget
{
    private static readonly double[] Rates = [0.5, 1, 1.5, 2];
    private static readonly RotationOrder[] Orders = Enum.GetValues<RotationOrder>();

    public static void Run(FuzzInput input)
    {
        var document = BvhDocument.Parse(input.Bytes);
        CheckWritten(document, input);
        for (int i = 0; i < 3; i++)
        {
            try
            {
                document = Change(document, input);
            }
            catch (NeuronException refusal) when (refusal is not BvhFormatException)
            {
                input.Digest.Add(refusal.Message);
                continue;
            }

            input.Found++;
            CheckWritten(document, input);
        }
    }

    private static BvhDocument Change(BvhDocument document, FuzzInput input)
    {
        ref FuzzRandom random = ref input.Random;
        switch (random.Below(9))
        {
            case 0:
                int start = random.Below(document.FrameCount + 1);
                return document.Trim(start, random.Below(document.FrameCount - start + 1));
            case 1:
                return Resample(document, document.FrameRate * random.Choose(Rates));
            case 2:
                return document.Mirror();
            case 3:
                return document.WithRotationOrder(random.Choose(Orders));
            case 4:
                return document.FilterEulerAngles();
            case 5:
                return document.WithDisplacement();
            case 6:
                return document.WithoutDisplacement(out _);
            case 7:
                return document.WithVariant(random.Below(2) == 0 ? SkeletonVariant.Neck1 : SkeletonVariant.Spine3);
            default:
                return BvhEditing.Join([document, document], align: random.Below(2) == 0);
        }
    }

    // Rates that no file can have are rejected, as documented.
    private static BvhDocument Resample(BvhDocument document, double rate)
    {
        try
        {
            return document.Resample(rate);
        }
        catch (ArgumentException)
        {
            return document;
        }
    }

    private static void CheckWritten(BvhDocument document, FuzzInput input)
    {
        using var text = new MemoryStream();
        document.Save(text);
        WrongResultException.ThrowUnless(text.Length <= 64 * 1024 * 1024, "{0} bytes are written of {1}.", text.Length, input.Bytes.Length);
        var again = BvhDocument.Parse(text.GetBuffer().AsSpan(0, (int)text.Length));
        WrongResultException.ThrowUnless(
            (again.FrameCount, again.ChannelCount, again.Joints.Count) == (document.FrameCount, document.ChannelCount, document.Joints.Count),
            "What was written has {0} frames of {1} channels and {2} joints.", again.FrameCount, again.ChannelCount, again.Joints.Count);
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            WrongResultException.ThrowUnless(IsSame(document, again, frame), "What was written has other values in frame {0}.", frame);
            input.Digest.Add((long)FloatBits.Sum(document.GetValues(frame)));
        }
    }

    // Compares joint by joint, because columns in another order are written in the order of the joints.
    private static bool IsSame(BvhDocument document, BvhDocument again, int frame)
    {
        for (int i = 0; i < document.Joints.Count; i++)
        {
            (BvhJoint first, BvhJoint second) = (document.Joints[i], again.Joints[i]);
            bool isSame = first.Channels.Count == second.Channels.Count
                && FloatBits.AreSame(
                    document.GetValues(frame).Slice(first.FirstChannel, first.Channels.Count), again.GetValues(frame).Slice(second.FirstChannel, second.Channels.Count));
            if (!isSame)
                return false;
        }

        return true;
    }
}
