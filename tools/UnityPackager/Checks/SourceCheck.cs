using System.Text.RegularExpressions;

namespace NeuronMocap.UnityPackager.Checks;

/// <summary>
/// Checks that runtime sources use the editor only inside #if UNITY_EDITOR. Sources must be nullable and use a namespace of the package.
/// </summary>
internal static partial class SourceCheck
{
    public static IEnumerable<string> Check(StagedPackage package)
    {
        IReadOnlyList<AssemblyDefinition> definitions = AssemblyDefinition.FindAll(package);
        foreach (string path in package.AssetFiles.Where(static path => path.EndsWith(".cs", StringComparison.Ordinal)))
        {
            string[] lines = package.ReadText(path).Split('\n');
            if (!Has(lines, "[assembly:") && !Has(lines, "#nullable enable"))
                yield return $"{path}: lacks #nullable enable";
            if (!Has(lines, "[assembly:") && !Has(lines, "namespace NeuronMocap.Unity"))
                yield return $"{path}: does not use a namespace of the package";
            if (Path.GetFileNameWithoutExtension(path).Split('.')[0] is var name && Array.Exists(lines, line => Component().IsMatch(line)) && !Array.Exists(lines, line => Component().Match(line).Groups["name"].Value == name))
                yield return $"{path}: Unity finds a component only in a file with its name";
            if (AssemblyDefinition.Owning(path, definitions) is { IsEditorOnly: false } && FindUnguarded(lines) is { } number)
                yield return $"{path}:{number}: uses the editor outside #if UNITY_EDITOR";
        }
    }

    private static bool Has(string[] lines, string start) => Array.Exists(lines, line => line.StartsWith(start, StringComparison.Ordinal));

    // Returns the number of the first line, from 1.
    private static int? FindUnguarded(string[] lines)
    {
        var guards = new Stack<Guard>();
        for (int i = 0; i < lines.Length; i++)
        {
            string line = lines[i].Trim();
            if (line.StartsWith("#if", StringComparison.Ordinal))
                guards.Push(GuardOf(line));
            else if (line.StartsWith("#elif", StringComparison.Ordinal) && guards.TryPop(out _))
                guards.Push(GuardOf(line));
            else if (line.StartsWith("#else", StringComparison.Ordinal) && guards.TryPop(out Guard before))
                guards.Push(before switch { Guard.Editor => Guard.Player, Guard.Player => Guard.Editor, _ => Guard.Other });
            else if (line.StartsWith("#endif", StringComparison.Ordinal))
                guards.TryPop(out _);
            else if (!guards.Contains(Guard.Editor) && EditorName().IsMatch(Comment().Replace(line, string.Empty)))
                return i + 1;
        }

        return null;
    }

    // "UNITY_EDITOR || X" is also true outside the editor.
    private static Guard GuardOf(string condition)
    {
        if (!condition.Contains("UNITY_EDITOR", StringComparison.Ordinal) || condition.Contains("||", StringComparison.Ordinal))
            return Guard.Other;

        return condition.Contains("!UNITY_EDITOR", StringComparison.Ordinal) ? Guard.Player : Guard.Editor;
    }

    // The effect of a condition on the lines below it.
    private enum Guard
    {
        Other,
        Editor,
        Player,
    }

    [GeneratedRegex(@"\bUnityEditor\b", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex EditorName();

    [GeneratedRegex(@"\bclass (?<name>\w+)\s*:\s*(MonoBehaviour|ScriptableObject|FigureDriver)\b", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Component();

    [GeneratedRegex("//.*$", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Comment();
}
