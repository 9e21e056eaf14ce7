using System.Text;

namespace NeuronMocap.Retargeting;

// The meaning of a node's name, independent of spelling: "LeftUpLeg", "left up leg" and "up_leg.L" are (Left, "upleg").
internal readonly record struct NodeName(BodySide Side, string Part)
{
    public static NodeName Read(string name)
    {
        var part = new StringBuilder();
        BodySide side = BodySide.None;
        foreach (string word in Words(AfterNamespace(name)))
        {
            BodySide said = SideOf(word);
            if (said != BodySide.None && side == BodySide.None)
                side = said;
            else if (word is not "c")
                part.Append(word);
        }

        string whole = part.ToString();
        if (side == BodySide.None)
        {
            // A name without capitals and separators, such as "leftarm".
            if (whole.StartsWith("left", StringComparison.Ordinal))
                return new NodeName(BodySide.Left, whole["left".Length..]);
            if (whole.StartsWith("right", StringComparison.Ordinal))
                return new NodeName(BodySide.Right, whole["right".Length..]);
        }

        return new NodeName(side, whole);
    }

    private static BodySide SideOf(string word) => word switch
    {
        "left" or "l" => BodySide.Left,
        "right" or "r" => BodySide.Right,
        _ => BodySide.None,
    };

    // Removes the prefixes of modelling programs, such as "mixamorig:" and "character|".
    private static string AfterNamespace(string name) => name[(name.LastIndexOfAny([':', '|']) + 1)..];

    // Words in lower case. A word ends at a separator, before a capital letter and before a number.
    private static IEnumerable<string> Words(string name)
    {
        int start = 0;
        for (int i = 0; i <= name.Length; i++)
        {
            bool separator = i < name.Length && !char.IsLetterOrDigit(name[i]);
            bool begins = i < name.Length && i > start
                && ((char.IsUpper(name[i]) && !char.IsUpper(name[i - 1])) || char.IsDigit(name[i]) != char.IsDigit(name[i - 1]));
            if (i < name.Length && !separator && !begins)
                continue;

            if (i > start)
                yield return name[start..i].ToLowerInvariant();
            start = separator ? i + 1 : i;
        }
    }
}

internal enum BodySide
{
    None,
    Left,
    Right,
}
