using System.CommandLine;
using System.CommandLine.Parsing;

namespace NeuronMocap.Tool.Files;

/// <summary>Keeps a file from getting the name of another kind of file.</summary>
internal static class FileNames
{
    /// <summary>Adds an error where the extension of an option's file is another one. A name without an extension is nobody's.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="option">An option whose only argument is a file to write.</param>
    /// <param name="what">What is written, in words.</param>
    /// <param name="extension">Its extension, with the dot.</param>
    public static void Reject(CommandResult result, Option option, string what, string extension)
    {
        if (result.GetResult(option)?.Tokens is not [{ Value: var path }] || Path.GetExtension(path) is not { Length: > 0 } given)
            return;

        if (!given.Equals(extension, StringComparison.OrdinalIgnoreCase))
            result.AddError($"{option.Name}: '{path}' ends with {given}, but {what} is written. Its name ends with {extension}.");
    }
}
