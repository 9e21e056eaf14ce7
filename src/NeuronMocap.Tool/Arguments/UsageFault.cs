using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Describes a wrong command line in one line.</summary>
internal static class UsageFault
{
    private const string HelpWord = "help";
    private const string VersionWord = "version";

    // Words after it are arguments.
    private const string EndOfOptions = "--";

    /// <summary>Finds the fault of a command line.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="args">Its words. The parser divides --json=1 into two, and the second could be an argument.</param>
    /// <returns>A sentence and where to find help; null if nothing is wrong.</returns>
    public static string? Find(ParseResult result, IReadOnlyList<string> args)
    {
        Command command = result.CommandResult.Command;
        string[] leftOver = [.. TokensOf(result.CommandResult), .. result.UnmatchedTokens];
        if (command is not Verb)
            return FindWithoutVerb(result, leftOver);

        string help = $"{ToolCommand.Name} {command.Name}";
        string[] afterOptions = [.. args.SkipWhile(static word => word is not EndOfOptions)];
        if (leftOver.Except(afterOptions, StringComparer.Ordinal).FirstOrDefault(IsOption) is { } unknown)
            return WithHelp(help, DescribeUnknown(unknown, command));
        if (FindEmptyValue(command, args) is { } empty)
            return WithHelp(help, empty);
        if (FindSwallowed(result.CommandResult) is { } swallowed)
            return WithHelp(help, DescribeSwallowed(swallowed.Option, swallowed.Value, swallowed.IsKnown));
        if (FindNeedlessValue(command, args) is { } flag)
            return WithHelp(help, $"{flag} takes no value.");
        if (!args[0].Equals(command.Name, StringComparison.Ordinal) && result.UnmatchedTokens.Contains(args[0], StringComparer.Ordinal))
            return DescribeBeforeVerb(args[0], command);
        if (result.UnmatchedTokens.Count > 0)
            return WithHelp(help, $"'{result.UnmatchedTokens[0]}' is one argument too many.");
        if (FindMiscounted(result.CommandResult) is { } miscounted)
            return WithHelp(help, miscounted);

        return result.Errors.Count > 0 ? WithHelp(help, result.Errors[0].Message) : null;
    }

    /// <summary>Formats a fault as one line, with a pointer to the help.</summary>
    public static string WithHelp(string program, string fault) => $"{TerminalText.Clean(fault)} {program} --help lists the options.";

    private static string? FindWithoutVerb(ParseResult result, string[] leftOver)
    {
        Verb[] verbs = [.. result.RootCommandResult.Command.Subcommands.OfType<Verb>()];
        string? fault = leftOver switch
        {
            [var option, ..] when IsOption(option) => $"unknown option {option}{SuggestVerb(option, verbs)}",
            [var word, ..] => $"unknown verb '{word}'{SuggestCommand(word, verbs)}",
            _ => result.Errors.Count > 0 ? result.Errors[0].Message : null,
        };
        return fault is null ? null : $"{TerminalText.Clean(fault)} {ToolCommand.Name} --help lists the verbs.";
    }

    private static string DescribeBeforeVerb(string word, Command command) => word is HelpWord
        ? $"unknown verb '{word}': did you mean {ToolCommand.Name} {command.Name} --help? {ToolCommand.Name} --help lists the verbs."
        : WithHelp($"{ToolCommand.Name} {command.Name}", $"'{word}' is before the verb {command.Name}.");

    // Suggests a verb if the option is the name of a verb with dashes, or an option of a verb.
    private static string SuggestVerb(string option, Verb[] verbs)
    {
        if (option is "-?" or "-v" or "-V")
            return $": did you mean --{(option is "-?" ? HelpWord : VersionWord)}?";

        string name = NameOf(option);
        Verb? meant = Array.Find(verbs, verb => verb.Name.Equals(name, StringComparison.Ordinal));
        if (meant is not null)
            return $": did you mean {ToolCommand.Name} {meant.Name}?";

        Verb? owner = Array.Find(verbs, verb => NamesOf(verb).Any(other => NameOf(other).Equals(name, StringComparison.Ordinal)));
        return owner is null ? "." : $": did you mean {ToolCommand.Name} {owner.Name} --{name}?";
    }

    private static string SuggestCommand(string word, Verb[] verbs)
    {
        if (word is HelpWord or VersionWord)
            return $": did you mean --{word}?";
        if (word is "/?" or "/h")
            return $": did you mean --{HelpWord}?";
        if (Spelling.FindNearest(word, verbs.Select(static verb => verb.Name)) is { } verb)
            return $": did you mean {verb}?";

        bool isSource = word.AsSpan().ContainsAny('.', ':', '/') || File.Exists(word) || word.Equals(Source.Demo.ToString(), StringComparison.OrdinalIgnoreCase);
        return isSource ? $": did you mean {ToolCommand.Name} watch {word}?" : ".";
    }

    private static IEnumerable<string> TokensOf(CommandResult command) =>
        command.Children.OfType<ArgumentResult>().SelectMany(static argument => argument.Tokens).Select(static token => token.Value);

    // Finds an option whose value looks like another option. Without this check, a forgotten value would record to a file with an option's name.
    private static (string Option, string Value, bool IsKnown)? FindSwallowed(CommandResult command)
    {
        string[] names = [.. NamesOf(command.Command), "-h", "--help"];
        foreach (OptionResult option in command.Children.OfType<OptionResult>())
        {
            if (option.Tokens.FirstOrDefault(static token => token.Value.Length > 1 && token.Value[0] == '-' && !IsNumber(token.Value)) is { } token)
                return (option.IdentifierToken!.Value, token.Value, names.Contains(token.Value, StringComparer.Ordinal));
        }

        return null;
    }

    private static string DescribeSwallowed(string option, string value, bool isKnown) => isKnown
        ? $"{option} needs a value, and {value} is another option."
        : $"{option} needs a value, and {value} looks like another option. Write ./{value} for a file of that name.";

    // Finds an option with an empty value, as scripts write it: --from=$START. The parser would take the next word as the value.
    private static string? FindEmptyValue(Command command, IReadOnlyList<string> args)
    {
        foreach (string word in args.TakeWhile(static word => word is not EndOfOptions).Where(static word => IsOption(word) && word[^1] is '=' or ':'))
        {
            string name = word[..^1];
            if (command.Options.FirstOrDefault(option => option.Arity.MaximumNumberOfValues > 0 && NamesOf(option).Contains(name, StringComparer.Ordinal)) is { } option)
                return $"{name} needs a value, {option.HelpName}.";
        }

        return null;
    }

    // Finds an option without values that is written with one, as in --json=1.
    private static string? FindNeedlessValue(Command command, IReadOnlyList<string> args)
    {
        string[] flags = [.. command.Options.Where(static option => option.Arity.MaximumNumberOfValues == 0).SelectMany(NamesOf)];
        return args.TakeWhile(static word => word is not EndOfOptions)
            .Select(static word => word.Split('=', ':'))
            .FirstOrDefault(parts => parts.Length > 1 && flags.Contains(parts[0], StringComparer.Ordinal))?[0];
    }

    // The parser also has sentences for these faults, but in its own words.
    private static string? FindMiscounted(CommandResult command)
    {
        foreach (OptionResult option in command.Children.OfType<OptionResult>())
        {
            if (option.Tokens.Count < option.Option.Arity.MinimumNumberOfValues)
                return $"{option.Option.Name} needs a value, {option.Option.HelpName}.";
            if (option.Option.Arity.MaximumNumberOfValues == 1 && option.IdentifierTokenCount > 1)
                return $"{option.Option.Name} is given more than once.";
        }

        Argument? missing = command.Command.Arguments.FirstOrDefault(
            argument => (command.GetResult(argument)?.Tokens.Count ?? 0) < argument.Arity.MinimumNumberOfValues);
        return missing is null ? null : $"{command.Command.Name} needs {missing.Name}.";
    }

    private static IEnumerable<string> NamesOf(Command command) => command.Options.SelectMany(NamesOf);

    private static IEnumerable<string> NamesOf(Option option) => option.Aliases.Prepend(option.Name);

    // The error for a negative number is that of its option.
    private static bool IsNumber(string token) => double.TryParse(token, NumberStyles.Float, CultureInfo.InvariantCulture, out _);

    private static bool IsOption(string token) => token.Length > 1 && token[0] == '-';

    private static string DescribeUnknown(string unknown, Command command)
    {
        string[] names = [.. NamesOf(command)];
        if (names.Contains(unknown, StringComparer.Ordinal))
            return $"{unknown} is before the verb: write {ToolCommand.Name} {command.Name} {unknown}.";

        string? meant = Spelling.FindNearest(NameOf(unknown), names.Select(NameOf));
        return $"unknown option {unknown}{(meant is null ? "." : $": did you mean --{meant}?")}";
    }

    private static string NameOf(string option) => option.Split('=', ':')[0].TrimStart('-').ToLowerInvariant();
}
