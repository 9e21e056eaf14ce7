using System.CommandLine;
using System.CommandLine.Parsing;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Checks the name of a file to write.</summary>
internal static class FileNames
{
    /// <summary>Adds an error if the file of an option has no name or the wrong extension. Names without an extension are allowed.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="option">An option whose only argument is a file to write.</param>
    /// <param name="what">Words for the contents of the file.</param>
    /// <param name="extension">The correct extension, with the dot.</param>
    public static void Reject(CommandResult result, Option option, string what, string extension)
    {
        if (result.GetResult(option)?.Tokens is not [{ Value: var path }])
            return;

        if (string.IsNullOrWhiteSpace(path))
            result.AddError($"{option.Name}: the name of the file is empty.");
        if (Path.GetExtension(path) is not { Length: > 0 } given)
            return;

        if (!given.Equals(extension, StringComparison.OrdinalIgnoreCase))
            result.AddError($"{option.Name}: '{path}' ends with {given}, but {what} is written. Its name ends with {extension}.");
    }
}
