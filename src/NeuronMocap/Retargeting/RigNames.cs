using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

// The names of the bones in one kind of rig: in lower case, without prefix, side and separators. "a/b" are alternatives, the most common name first.
internal sealed partial record RigNames
{
    private static readonly Bone[] Trunk = [Bone.Spine, Bone.Spine1, Bone.Spine2, Bone.Neck, Bone.Neck1];

    // Whether each name of spine and neck belongs to the bone of that name.
    public bool IsOwn { get; private init; }

    public string Hips { get; private init; } = "hips";

    // Any number of bones, from the lowest to the parent of the shoulders.
    public string Spine { get; private init; } = "";

    public string Neck { get; private init; } = "neck";

    public string Head { get; private init; } = "head";

    // Thigh, shin and foot.
    public string Leg { get; private init; } = "";

    // Collar bone, upper arm, forearm and hand.
    public string Arm { get; private init; } = "";

    public string Thumb { get; private init; } = "thumb1 thumb2 thumb3";

    // Index, middle, ring and little finger.
    public string Fingers { get; private init; } = "";

    // The palm bone and the three joints of a finger. * is the name of the finger, # its number from 1, - a bone that the rig lacks.
    public string Joints { get; private init; } = "";

    public static IEnumerable<string> HipsWords => Neck1Rows.SelectMany(static row => Alternatives(row.Hips)).Distinct(StringComparer.Ordinal);

    public IEnumerable<NodeName> HipsNames => Alternatives(Hips).Select(NodeName.Read);

    public IReadOnlyList<NodeName[]> SpineNames => InMiddle(Spine);

    public IReadOnlyList<NodeName[]> NeckNames => InMiddle(Neck);

    // The bones of the stream that the spine and the neck consist of.
    public static ReadOnlySpan<Bone> SpineBones(SkeletonVariant variant) => Trunk.AsSpan(0, variant == SkeletonVariant.Spine3 ? 4 : 3);

    public static ReadOnlySpan<Bone> NeckBones(SkeletonVariant variant) => Trunk.AsSpan(variant == SkeletonVariant.Spine3 ? 4 : 3);

    // All bones except those of spine and neck.
    public IEnumerable<(Bone Bone, NodeName[] Names)> Others()
    {
        yield return (Bone.Hips, InMiddle(Hips)[0]);
        yield return (Bone.Head, InMiddle(Head)[0]);
        foreach (BodySide side in new[] { BodySide.Right, BodySide.Left })
        {
            (Bone thigh, Bone shoulder) = side == BodySide.Right ? (Bone.RightUpLeg, Bone.RightShoulder) : (Bone.LeftUpLeg, Bone.LeftShoulder);
            foreach ((int number, string names) in Words(Leg))
                yield return (thigh + number, On(side, names));
            foreach ((int number, string names) in Words(Arm).Concat(HandWords()))
                yield return (shoulder + number, On(side, names));
        }
    }

    private static NodeName[][] InMiddle(string words) => [.. Words(words).Select(word => Alternatives(word.Names).Select(NodeName.Read).ToArray())];

    private static NodeName[] On(BodySide side, string names) => [.. Alternatives(names).Select(name => new NodeName(side, name))];

    private static IEnumerable<(int Number, string Names)> Words(string words) =>
        words.Split([' '], StringSplitOptions.RemoveEmptyEntries).Select(static (word, number) => (number, word));

    private static string[] Alternatives(string names) => names.Split('/');

    // The bones of the hand, numbered from the collar bone: in the stream, the three bones of the thumb follow the hand, then a palm bone and three
    // joints for each finger.
    private IEnumerable<(int Number, string Names)> HandWords()
    {
        const int FirstOfThumb = 4;
        const int FirstOfFingers = FirstOfThumb + 3;
        if (Fingers.Length == 0)
            yield break;

        foreach ((int number, string names) in Words(Thumb))
            yield return (FirstOfThumb + number, names);
        foreach ((int finger, string fingerNames) in Words(Fingers))
        {
            foreach ((int joint, string patterns) in Words(Joints).Where(static word => word.Names is not "-"))
            {
                IEnumerable<string> names = Alternatives(patterns).SelectMany(pattern => Alternatives(fingerNames).Select(name => Fill(pattern, name, finger)));
                yield return (FirstOfFingers + (finger * 4) + joint, string.Join("/", names));
            }
        }
    }

    private static string Fill(string pattern, string finger, int number) =>
        pattern.Replace("*", finger, StringComparison.Ordinal).Replace('#', (char)('1' + number));
}
