using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

// The names of Neuron's bones in one hierarchy. Other programs put the name of the character before all of them: "Robot:Hips", "Robot_Hips".
internal sealed class BvhBoneNames
{
    public const string Reference = "Reference";
    private const string Hips = "Hips";

    private readonly string _prefix;

    public BvhBoneNames(IReadOnlyList<BvhJoint> joints)
    {
        string hips = joints.FirstOrDefault(static joint => joint.Parent?.Parent is null && EndsWithWord(joint.Name, Hips))?.Name ?? Hips;
        _prefix = hips[..^Hips.Length];
        bool hasSpine3 = joints.Any(joint => string.Equals(joint.Name, _prefix + "Spine3", StringComparison.Ordinal));
        Variant = hasSpine3 ? SkeletonVariant.Spine3 : SkeletonVariant.Neck1;
    }

    public SkeletonVariant Variant { get; }

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
