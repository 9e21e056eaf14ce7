namespace NeuronMocap.Tool.Figures;

/// <summary>Interprets common joint names of BVH files: LeftFoot, lfoot, foot_L, l_ankle, LHand.</summary>
internal static class JointNames
{
    public static BodyPart PartOf(string name)
    {
        if (name.Contains("left", StringComparison.OrdinalIgnoreCase))
            return BodyPart.Left;
        if (name.Contains("right", StringComparison.OrdinalIgnoreCase))
            return BodyPart.Right;

        return HasInitial(name, 'l') ? BodyPart.Left : HasInitial(name, 'r') ? BodyPart.Right : BodyPart.Middle;
    }

    public static bool IsFoot(string name) => Contains(name, "foot") || Contains(name, "ankle");

    public static bool IsHand(string name) => Contains(name, "hand") || Contains(name, "wrist");

    public static bool IsThigh(string name) => Contains(name, "upleg") || Contains(name, "thigh") || Contains(name, "upperleg") || Contains(name, "hip");

    private static bool Contains(string name, string part) => name.Contains(part, StringComparison.OrdinalIgnoreCase);

    // An initial counts only if the following text shows that it is one: lFoot, LFoot, l_foot, foot_l, foot.R. "lowerback" and "root" have none.
    private static bool HasInitial(string name, char initial)
    {
        if (name.Length < 2)
            return false;

        bool first = char.ToLowerInvariant(name[0]) == initial && (name[1] is '_' or '.' or '-' or ' ' || char.IsUpper(name[1])
            || IsFoot(name) || IsHand(name) || IsThigh(name));
        bool last = char.ToLowerInvariant(name[^1]) == initial && name[^2] is '_' or '.' or '-' or ' ';
        return first || last;
    }
}
