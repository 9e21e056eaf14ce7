using System.Text;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Names of files that pages send. They are shown and put into headers, and never used as paths.</summary>
internal static class TakeName
{
    private const int Longest = 100;
    private const string Usual = "take";

    /// <summary>Makes a name that can be shown.</summary>
    public static string Clean(string name)
    {
        string last = name[(name.LastIndexOfAny(['/', '\\']) + 1)..];
        var clean = new StringBuilder();
        foreach (Rune letter in last.EnumerateRunes())
        {
            if (clean.Length < Longest && !Rune.IsControl(letter) && letter.Value is not ('"' or '<' or '>' or '|' or ':' or '*' or '?' or 0xFFFD))
                clean.Append(letter.ToString());
        }

        string text = clean.ToString().Trim().TrimStart('.');
        return text.Length > 0 ? text : Usual;
    }
}
