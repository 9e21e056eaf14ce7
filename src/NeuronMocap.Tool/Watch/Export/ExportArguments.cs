using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Watch.Export;

/// <summary>The options for exporting a stream as BVH.</summary>
internal sealed class ExportArguments
{
    private const string Everyone = "all";

    private readonly Option<string?> _export;

    private readonly Option<string?> _avatar = new("--export-avatar")
    {
        HelpName = "N|all",
        Description = "With --export: number of the avatar to write, from 0, or all for one file per avatar, with its number in the name. Default: the first to arrive.",
        CustomParser = static result =>
        {
            string text = result.Tokens[0].Value;
            if (IsAll(text) || int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out _))
                return text;

            result.AddError($"--export-avatar: '{text}' is not an avatar number, from 0, or all.");
            return null;
        },
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>Creates the options.</summary>
    /// <param name="body">Where the bone lengths come from.</param>
    public ExportArguments(string body) => _export = new Option<string?>("--export")
    {
        HelpName = "FILE.bvh",
        Description = "Also write the motion frames to this BVH file. An existing file is an error unless --overwrite is given. "
            + $"The bone lengths come from {body}, or from the manual's Appendix B.",
        Arity = ArgumentArity.ExactlyOne,
    };

    /// <summary>The option that names the file.</summary>
    public Option File => _export;

    public Option[] All => [_export, _avatar];

    /// <summary>Adds an error for every option that needs another option.</summary>
    public void RejectContradictions(CommandResult result)
    {
        if (Verb.IsGiven(result, _avatar) && !Verb.IsGiven(result, _export))
            result.AddError("--export-avatar needs --export: it says what is written.");

        FileNames.Reject(result, _export, "a BVH file", ".bvh");
    }

    public ExportSettings? Read(ParseResult result, bool overwrite)
    {
        if (result.GetValue(_export) is not { } path)
            return null;

        string? avatar = result.GetValue(_avatar);
        bool isAll = avatar is not null && IsAll(avatar);
        int? number = avatar is null || isAll ? null : int.Parse(avatar, CultureInfo.InvariantCulture);
        return new ExportSettings(path, overwrite, number, isAll);
    }

    private static bool IsAll(string text) => string.Equals(text, Everyone, StringComparison.OrdinalIgnoreCase);
}
