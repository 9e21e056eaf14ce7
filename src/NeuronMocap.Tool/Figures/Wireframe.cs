using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Figures;

/// <summary>The part of the body to which a line belongs.</summary>
internal enum BodyPart
{
    Middle,
    Left,
    Right,
}

/// <summary>A line of the drawn skeleton, between two of its <see cref="JointPositions"/>.</summary>
internal readonly record struct WireframeLine(int From, int To, BodyPart Part);

/// <summary>The lines of a drawn person, between the points of the 59 bones and the ends of the outermost bones.</summary>
internal static class Wireframe
{
    private static readonly WireframeLine[] Neck1 = [.. MakeLines(SkeletonVariant.Neck1)];
    private static readonly WireframeLine[] Spine3 = [.. MakeLines(SkeletonVariant.Spine3)];

    /// <summary>The point at the top of the head.</summary>
    public static int HeadTop { get; } = JointPositions.GetEndSiteIndex(Bone.Head);

    public static ReadOnlySpan<WireframeLine> Lines(SkeletonVariant variant) => variant == SkeletonVariant.Spine3 ? Spine3 : Neck1;

    private static IEnumerable<WireframeLine> MakeLines(SkeletonVariant variant)
    {
        foreach (Bone bone in BoneHierarchy.Bones.ToArray())
        {
            if (BoneHierarchy.GetParent(bone, variant) is { } parent)
                yield return new WireframeLine((int)parent, (int)bone, PartOf(bone));
        }

        foreach (Bone bone in JointPositions.EndSiteBones.ToArray())
            yield return new WireframeLine((int)bone, JointPositions.GetEndSiteIndex(bone), PartOf(bone));
    }

    public static BodyPart PartOf(Bone bone)
    {
        string name = bone.ToString();
        return name.StartsWith("Left", StringComparison.Ordinal) ? BodyPart.Left
            : name.StartsWith("Right", StringComparison.Ordinal) ? BodyPart.Right
            : BodyPart.Middle;
    }
}
