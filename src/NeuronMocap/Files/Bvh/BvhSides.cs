namespace NeuronMocap.Bvh;

// Finds the joint of the other side by name.
internal static class BvhSides
{
    private static readonly (string Left, string Right)[] Words = [("Left", "Right"), ("left", "right"), ("LEFT", "RIGHT")];

    /// <summary>Finds the partner of every joint, starting at the roots. The children of partners are partners.</summary>
    /// <returns>The index of each joint's partner. A joint in the middle is its own partner.</returns>
    /// <exception cref="NeuronException">The joints of the two sides do not match.</exception>
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

    /// <summary>Lists the possible names of the other side's joint.</summary>
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
            ?? throw new NeuronException($"The sides do not match: {joint.Name} is a child of {joint.Parent!.Name}, but {otherParent!.Name} has no matching child.");
    }

    // Returns whether a letter may stand for a side. Such a letter is at the beginning or the end of the name, or next to a sign. It is also set
    // off from its neighbours: lArm, LArm, Arm_L, Arm.l, "Bip01 L Thigh", ArmL. Only the other side's name can confirm it: in lowerBack, the letter
    // does not stand for a side.
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
