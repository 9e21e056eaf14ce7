using System.CommandLine;
using System.CommandLine.Parsing;

namespace NeuronMocap.Tool.Files;

/// <summary>Finds options that would write over each other's file, or over the one that is played.</summary>
internal static class SameFile
{
    private static readonly StringComparison Comparison =
        OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? StringComparison.OrdinalIgnoreCase : StringComparison.Ordinal;

    /// <summary>Adds an error where two options name one file.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="options">Options whose only argument is a file.</param>
    public static void Reject(CommandResult result, params Option[] options)
    {
        (string Option, string Path)[] files =
        [
            .. options.Select(option => (option.Name, PathOf(result, option))).Where(static file => file.Item2.Length > 0),
        ];
        for (int i = 0; i < files.Length; i++)
        {
            foreach ((string option, _) in files[(i + 1)..].Where(other => string.Equals(other.Path, files[i].Path, Comparison)))
                result.AddError($"{files[i].Option} and {option} name the same file.");
        }
    }

    private static string PathOf(CommandResult result, Option option) =>
        result.GetResult(option)?.Tokens is [{ Value: var path }] && !string.IsNullOrWhiteSpace(path) ? Path.GetFullPath(path) : string.Empty;
}
