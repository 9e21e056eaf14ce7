using NeuronMocap.Retargeting;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>The names that VRM 1.0 gives the Humanoid bones.</summary>
internal static class VrmBoneNames
{
    private static readonly string[] Names = [.. Enumerable.Range(0, HumanoidBones.Count).Select(static bone => Spell((HumanoidBone)bone))];

    private static readonly Dictionary<string, HumanoidBone> Bones =
        Enumerable.Range(0, HumanoidBones.Count).ToDictionary(static bone => Names[bone], static bone => (HumanoidBone)bone, StringComparer.Ordinal);

    public static string Of(HumanoidBone bone) => Names[(int)bone];

    /// <summary>Writes the name in words: "left upper leg".</summary>
    public static string InWords(HumanoidBone bone) =>
        string.Concat(bone.ToString().Select(static (letter, place) => char.IsUpper(letter) && place > 0 ? $" {char.ToLowerInvariant(letter)}" : $"{char.ToLowerInvariant(letter)}"));

    public static bool TryFind(string name, out HumanoidBone bone) => Bones.TryGetValue(name, out bone);

    // VRM begins the thumb with its metacarpal bone, so its three names are one bone off.
    private static string Spell(HumanoidBone bone)
    {
        string name = bone.ToString();
        if (name.EndsWith("ThumbProximal", StringComparison.Ordinal))
            name = name.Replace("Proximal", "Metacarpal", StringComparison.Ordinal);
        else if (name.EndsWith("ThumbIntermediate", StringComparison.Ordinal))
            name = name.Replace("Intermediate", "Proximal", StringComparison.Ordinal);

        return char.ToLowerInvariant(name[0]) + name[1..];
    }
}
