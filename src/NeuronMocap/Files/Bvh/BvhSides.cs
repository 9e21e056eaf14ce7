namespace NeuronMocap.Bvh;

// Which joint is the other side's, by names.
internal static class BvhSides
{
    private static readonly (string Left, string Right)[] Words = [("Left", "Right"), ("left", "right"), ("LEFT", "RIGHT")];

    /// <summary>Finds the partner of every joint, from the roots on: the children of partners are partners.</summary>
    /// <returns>An index for each joint, its own where it is in the middle.</returns>
    /// <exception cref="NeuronException">The joints of the two sides do not correspond.</exception>
    public static int[] FindPartners(BvhHierarchy hierarchy)
    {
        ILookup<BvhJoint?, BvhJoint> children = hierarchy.Joints.ToLookup(static joint => joint.Parent);
        int[] partners = new int[hierarchy.Joints.Count];
        Array.Fill(partners, -1);
        foreach (BvhJoint joint in hierarchy.Joints)
        {
            if (partners[joint.Index] >= 0)
                continue;

            BvhJoint? otherParent = joint.Parent is { } parent ? hierarchy.Joints[partners[parent.Index]] : null;
            BvhJoint partner = FindPartner(joint, children[otherParent].Where(other => partners[other.Index] < 0), otherParent);
            partners[joint.Index] = partner.Index;
            partners[partner.Index] = joint.Index;
        }

        return partners;
    }

    /// <summary>The names that the joint of the other side may have.</summary>
    public static IEnumerable<string> OtherNames(string name)
    {
        foreach ((string left, string right) in Words)
        {
            if (name.Contains(left, StringComparison.Ordinal))
                yield return name.Replace(left, right, StringComparison.Ordinal);
            if (name.Contains(right, StringComparison.Ordinal))
                yield return name.Replace(right, left, StringComparison.Ordinal);
        }

        for (int i = 0; i < name.Length; i++)
        {
            if (name[i] is 'L' or 'R' or 'l' or 'r' && IsAlone(name, i))
                yield return name[..i] + Other(name[i]) + name[(i + 1)..];
        }
    }

    private static BvhJoint FindPartner(BvhJoint joint, IEnumerable<BvhJoint> candidates, BvhJoint? otherParent)
    {
        BvhJoint[] found = [.. candidates];
        string[] names = [.. OtherNames(joint.Name)];
        BvhJoint? partner = found.FirstOrDefault(other => other != joint && names.Contains(other.Name, StringComparer.Ordinal))
            ?? (joint.Parent == otherParent ? joint : found.FirstOrDefault(other => string.Equals(other.Name, joint.Name, StringComparison.Ordinal)));
        return partner
            ?? throw new NeuronException($"The sides do not correspond: {joint.Name} is a child of {joint.Parent!.Name}, and {otherParent!.Name} has no child like it.");
    }

    // A letter that stands for a side: at the beginning or the end of the name or next to a sign, and set off from the letters beside it: lArm, LArm, Arm_L,
    // Arm.l, "Bip01 L Thigh", ArmL. Whether it does, only the other side's name can tell: in lowerBack it does not.
    private static bool IsAlone(string name, int index)
    {
        bool begins = index == 0 || !char.IsLetterOrDigit(name[index - 1]);
        bool ends = index == name.Length - 1 || !char.IsLetterOrDigit(name[index + 1]);
        bool isSetOff = index < name.Length - 1 && char.IsUpper(name[index + 1]);
        return (begins && (ends || isSetOff)) || (ends && index > 0 && char.IsUpper(name[index]) && !char.IsUpper(name[index - 1]));
    }

    private static char Other(char side) => side switch
    {
        'L' => 'R',
        'R' => 'L',
        'l' => 'r',
        _ => 'l',
    };
}
