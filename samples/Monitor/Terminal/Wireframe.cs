using NeuronMocap.Skeleton;

namespace NeuronMocap.Monitor.Terminal;

/// <summary>Which part of the body a line belongs to.</summary>
internal enum BodyPart
{
    Middle,
    Left,
    Right,
}

/// <summary>A line of the drawn skeleton, between two points of a <see cref="Pose"/>.</summary>
internal readonly record struct WireframeLine(int From, int To, BodyPart Part);

/// <summary>The points and lines that make a person: the 59 bones and where the outermost ones end.</summary>
internal static class Wireframe
{
    private static readonly Bone[] Outermost = [.. FindOutermost()];
    private static readonly WireframeLine[] Neck1 = [.. MakeLines(SkeletonVariant.Neck1)];
    private static readonly WireframeLine[] Spine3 = [.. MakeLines(SkeletonVariant.Spine3)];

    /// <summary>Bones first, in their order, then the ends.</summary>
    public static int PointCount => BoneHierarchy.BoneCount + Outermost.Length;

    /// <summary>The point at the top of the head.</summary>
    public static int HeadTop { get; } = BoneHierarchy.BoneCount + Array.IndexOf(Outermost, Bone.Head);

    public static ReadOnlySpan<WireframeLine> Lines(SkeletonVariant variant) => variant == SkeletonVariant.Spine3 ? Spine3 : Neck1;

    /// <summary>The bones that have an end of their own, in the order of the points behind the bones.</summary>
    public static ReadOnlySpan<Bone> EndBones => Outermost;

    private static IEnumerable<Bone> FindOutermost() =>
        BoneHierarchy.Bones.ToArray().Where(bone => DefaultOffsets.TryGetEndSite(bone, out _));

    private static IEnumerable<WireframeLine> MakeLines(SkeletonVariant variant)
    {
        foreach (Bone bone in BoneHierarchy.Bones.ToArray())
        {
            if (BoneHierarchy.GetParent(bone, variant) is { } parent)
                yield return new WireframeLine((int)parent, (int)bone, PartOf(bone));
        }

        for (int i = 0; i < Outermost.Length; i++)
            yield return new WireframeLine((int)Outermost[i], BoneHierarchy.BoneCount + i, PartOf(Outermost[i]));
    }

    public static BodyPart PartOf(Bone bone)
    {
        string name = bone.ToString();
        return name.StartsWith("Left", StringComparison.Ordinal) ? BodyPart.Left
            : name.StartsWith("Right", StringComparison.Ordinal) ? BodyPart.Right
            : BodyPart.Middle;
    }
}
