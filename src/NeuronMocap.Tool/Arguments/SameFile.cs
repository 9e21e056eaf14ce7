using System.CommandLine;
using System.CommandLine.Parsing;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Finds options that would overwrite each other's file, or the file that is played.</summary>
internal static class SameFile
{
    private static readonly StringComparison Comparison =
        OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? StringComparison.OrdinalIgnoreCase : StringComparison.Ordinal;

    /// <summary>Adds an error if two arguments of a command line name the same file.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="input">The name of an argument and its file; null for none.</param>
    /// <param name="options">Options whose only argument is a file.</param>
    public static void Reject(CommandResult result, (string Argument, string Path)? input, params Option[] options)
    {
        IEnumerable<(string Option, string Path)> named = options.Select(option => (option.Name, PathOf(result, option)));
        if (input is { } file && !string.IsNullOrWhiteSpace(file.Path))
            named = named.Prepend((file.Argument, Path.GetFullPath(file.Path)));

        (string Option, string Path)[] files = [.. named.Where(static file => file.Path.Length > 0)];
        for (int i = 0; i < files.Length; i++)
        {
            foreach ((string option, _) in files[(i + 1)..].Where(other => string.Equals(other.Path, files[i].Path, Comparison)))
                result.AddError($"{files[i].Option} and {option} name the same file.");
        }
    }

    /// <summary>Whether two names mean the same file.</summary>
    public static bool IsSame(string one, string other) => string.Equals(Path.GetFullPath(one), Path.GetFullPath(other), Comparison);

    private static string PathOf(CommandResult result, Option option) =>
        result.GetResult(option)?.Tokens is [{ Value: var path }] && !string.IsNullOrWhiteSpace(path) ? Path.GetFullPath(path) : string.Empty;
}
