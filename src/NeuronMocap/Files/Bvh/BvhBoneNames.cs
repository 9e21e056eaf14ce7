using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

// The names of Neuron's bones in one hierarchy. Other programs put the name of the character before all of them: "Robot:Hips", "Robot_Hips".
internal sealed class BvhBoneNames
{
    public const string Reference = "Reference";
    private const string Hips = "Hips";

    private readonly string _prefix;

    private BvhBoneNames(string prefix, HashSet<string> joints)
    {
        _prefix = prefix;
        Variant = joints.Contains(prefix + "Spine3") ? SkeletonVariant.Spine3 : SkeletonVariant.Neck1;
    }

    public SkeletonVariant Variant { get; }

    // Finds the first prefix with which all bones have a joint. Plain names come first, because helpers such as Ctrl_Hips can stand above them.
    public static BvhBoneNames Find(IReadOnlyList<BvhJoint> joints)
    {
        HashSet<string> names = new(joints.Select(static joint => joint.Name), StringComparer.Ordinal);
        BvhBoneNames[] candidates =
        [
            .. joints.Where(static joint => joint.Parent?.Parent is null && EndsWithWord(joint.Name, Hips))
                .Select(static joint => joint.Name[..^Hips.Length]).OrderBy(static prefix => prefix.Length > 0).Select(prefix => new BvhBoneNames(prefix, names)),
        ];
        return candidates.FirstOrDefault(candidate => BoneHierarchy.Bones.ToArray().All(bone => names.Contains(candidate[bone])))
            ?? candidates.FirstOrDefault() ?? new BvhBoneNames(string.Empty, names);
    }

    public string this[Bone bone] => _prefix + BoneHierarchy.GetName(bone, Variant);

    public bool TryFind(BvhJoint joint, out Bone bone)
    {
        bone = default;
        return joint.Name.StartsWith(_prefix, StringComparison.Ordinal) && BoneHierarchy.TryFind(joint.Name.AsSpan(_prefix.Length), Variant, out bone);
    }

    // Returns whether a joint is the root that Axis Neuron writes above the hips on request.
    public static bool IsReference(BvhJoint? joint) => joint is { Parent: null } && EndsWithWord(joint.Name, Reference);

    // A letter or digit before the word would make it another word.
    private static bool EndsWithWord(string name, string word) =>
        name.EndsWith(word, StringComparison.Ordinal) && (name.Length == word.Length || !char.IsLetterOrDigit(name[name.Length - word.Length - 1]));
}
