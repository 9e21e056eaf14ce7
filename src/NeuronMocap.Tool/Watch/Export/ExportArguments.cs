using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Watch.Export;

/// <summary>The options of keeping a stream as BVH.</summary>
/// <param name="overwrite">The option that lets a file be replaced.</param>
internal sealed class ExportArguments(Option<bool> overwrite)
{
    private const string All = "all";

    private readonly Option<string?> _export = new("--export")
    {
        HelpName = "FILE.bvh",
        Description = "Write the motion frames into this BVH file as well, whatever is shown. A file that is there already is an error unless --overwrite is given. "
            + "The bones' lengths are those of the stream (displacement on), or of the command channel (--command-port), or those of the manual's Appendix B.",
        Arity = ArgumentArity.ExactlyOne,
    };

    private readonly Option<string?> _avatar = new("--export-avatar")
    {
        HelpName = "N|all",
        Description = "With --export: the avatar to write, from 0, or all for a file each, with the avatar's number in its name. Default: the one that comes first.",
        CustomParser = static result =>
        {
            string text = result.Tokens[0].Value;
            if (IsAll(text) || int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out _))
                return text;

            result.AddError($"--export-avatar: '{text}' is not a number of an avatar, from 0, or all.");
            return null;
        },
        Arity = ArgumentArity.ExactlyOne,
    };

    public Option File => _export;

    /// <summary>The options that are about a stream.</summary>
    public Option[] Own => [_export, _avatar];

    public void AddTo(RootCommand root)
    {
        root.Options.Add(_export);
        root.Options.Add(_avatar);
    }

    /// <summary>Adds an error for every option that has no meaning beside another.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="others">Options that show no stream.</param>
    public void RejectContradictions(CommandResult result, Option[] others)
    {
        if (CommandLine.IsGiven(result, _avatar) && !IsGiven(result))
            result.AddError("--export-avatar needs --export: it says what is written.");
        if (!IsGiven(result))
            return;

        FileNames.Reject(result, _export, "a BVH file", ".bvh");
        foreach (Option option in others.Where(option => CommandLine.IsGiven(result, option)))
            result.AddError($"{option.Name} and --export exclude each other: there is no stream to write.");
    }

    public bool IsGiven(CommandResult result) => CommandLine.IsGiven(result, _export);

    public ExportSettings? Read(ParseResult result)
    {
        if (result.GetValue(_export) is not { } path)
            return null;

        string? avatar = result.GetValue(_avatar);
        bool isAll = avatar is not null && IsAll(avatar);
        int? number = avatar is null || isAll ? null : int.Parse(avatar, CultureInfo.InvariantCulture);
        return new ExportSettings(path, result.GetValue(overwrite), number, isAll);
    }

    private static bool IsAll(string text) => string.Equals(text, All, StringComparison.OrdinalIgnoreCase);
}
