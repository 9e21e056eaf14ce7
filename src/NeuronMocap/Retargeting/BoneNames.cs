using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

// The names that other rigs use for the bones, the most common name first. Within a variant, no name belongs to two bones.
internal static class BoneNames
{
    private static readonly NodeName[][] Neck1 = Table(SkeletonVariant.Neck1);
    private static readonly NodeName[][] Spine3 = Table(SkeletonVariant.Spine3);

    public static string[] OfHips { get; } = ["Hips", "Pelvis", "Hip"];

    public static NodeName[] Of(Bone bone, SkeletonVariant variant) => (variant == SkeletonVariant.Spine3 ? Spine3 : Neck1)[(int)bone];

    private static NodeName[][] Table(SkeletonVariant variant) =>
        [.. BoneHierarchy.Bones.ToArray().Select(bone => Names(NodeName.Read(BoneHierarchy.GetName(bone, variant))))];

    private static NodeName[] Names(NodeName own) => [.. Others(own.Part).Prepend(own.Part).Select(part => own with { Part = part })];

    // Two-digit numbers start at one, as in "spine_01". One-digit numbers count the bones after the first, as in "Spine1".
    private static string[] Others(string part) => part switch
    {
        "hips" => ["pelvis", "hip"],
        "upleg" => ["upperleg", "thigh"],
        "leg" => ["lowerleg", "shin", "calf"],
        "foot" => ["ankle"],
        "spine" => ["spine01"],
        "spine1" => ["chest", "spine02"],
        "spine2" => ["upperchest", "spine03"],
        "spine3" => ["spine04"],
        "neck" => ["neck01"],
        "neck1" => ["neck02"],
        "shoulder" => ["clavicle", "collar", "collarbone"],
        "arm" => ["upperarm", "uparm"],
        "forearm" => ["lowerarm"],
        "hand" => ["wrist"],
        _ when part.StartsWith("inhand", StringComparison.Ordinal) => Finger(part["inhand".Length..], "metacarpal"),
        _ when part.StartsWith("hand", StringComparison.Ordinal) => Joint(part["hand".Length..^1], part[^1]),
        _ => [],
    };

    private static string[] Joint(string finger, char number) =>
        [.. Finger(finger, $"{number}"), .. Finger(finger, $"0{number}"), .. Finger(finger, number switch { '1' => "proximal", '2' => "intermediate", _ => "distal" })];

    private static string[] Finger(string finger, string joint) => finger is "pinky" ? ["pinky" + joint, "little" + joint] : [finger + joint];
}
