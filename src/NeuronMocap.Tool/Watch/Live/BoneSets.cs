using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>A page of the bone table.</summary>
internal readonly record struct BonePage(string Title, IReadOnlyList<Bone> Bones);

/// <summary>The sets of bones that the table shows together.</summary>
internal static class BoneSets
{
    private static readonly BonePage[] LongSets =
    [
        new("body", [.. CalculationOrder.Bones[..CalculationOrder.BodyBoneCount].ToArray().Order()]),
        new("right hand", Range(Bone.RightHand, Bone.RightHandPinky3)),
        new("left hand", Range(Bone.LeftHand, Bone.LeftHandPinky3)),
    ];

    private static readonly BonePage[] ShortSets =
    [
        new("overview", [Bone.Hips, Bone.Spine2, Bone.Head, Bone.RightHand, Bone.LeftHand, Bone.RightFoot, Bone.LeftFoot]),
        new("spine and head", [Bone.Hips, Bone.Spine, Bone.Spine1, Bone.Spine2, Bone.Neck, Bone.Neck1, Bone.Head]),
        new("legs", Range(Bone.RightUpLeg, Bone.LeftFoot)),
        new("right arm", Range(Bone.RightShoulder, Bone.RightHand)),
        new("left arm", Range(Bone.LeftShoulder, Bone.LeftHand)),
        new("right hand", Range(Bone.RightHand, Bone.RightHandPinky3)),
        new("left hand", Range(Bone.LeftHand, Bone.LeftHandPinky3)),
    ];

    /// <summary>Finds a page. A set with more bones than rows takes several pages.</summary>
    /// <param name="page">Number of the page. It starts at 0, wraps round and may be negative.</param>
    /// <param name="rows">Rows of a page, at least 1.</param>
    /// <returns>The page. Null for the place after the last page, which shows no table.</returns>
    public static BonePage? GetPage(int page, int rows)
    {
        BonePage[] sets = rows >= CalculationOrder.BodyBoneCount ? LongSets : ShortSets;
        BonePage[] pages = [.. sets.SelectMany(set => Split(set, Math.Max(rows, 1)))];
        int count = pages.Length + 1;
        int index = ((page % count) + count) % count;
        if (index == pages.Length)
            return null;

        return pages[index] with { Title = $"{pages[index].Title} ({index + 1}/{pages.Length})" };
    }

    private static IEnumerable<BonePage> Split(BonePage set, int rows) =>
        set.Bones.Chunk(rows).Select(bones => new BonePage(set.Title, bones));

    private static Bone[] Range(Bone first, Bone last) => [.. Enumerable.Range((int)first, last - first + 1).Select(index => (Bone)index)];
}
