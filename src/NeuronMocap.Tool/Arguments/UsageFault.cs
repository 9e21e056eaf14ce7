using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Describes a wrong command line in one line.</summary>
internal static class UsageFault
{
    /// <summary>Finds the fault of a command line.</summary>
    /// <param name="result">The command line.</param>
    /// <returns>A sentence and where to find help; null if nothing is wrong.</returns>
    public static string? Find(ParseResult result)
    {
        Command command = result.CommandResult.Command;
        string[] leftOver = [.. TokensOf(result.CommandResult), .. result.UnmatchedTokens];
        if (command is not Verb)
            return FindWithoutVerb(result, leftOver);

        string help = $"{ToolCommand.Name} {command.Name}";
        if (leftOver.FirstOrDefault(IsOption) is { } unknown)
            return WithHelp(help, DescribeUnknown(unknown, command));
        if (FindSwallowed(result.CommandResult) is { } swallowed)
            return WithHelp(help, $"{swallowed.Option} needs a value, and {swallowed.Value} is another option.");
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

    // Suggests a verb if the option is the name of a verb with dashes, or an option of a verb.
    private static string SuggestVerb(string option, Verb[] verbs)
    {
        string name = NameOf(option);
        Verb? meant = Array.Find(verbs, verb => verb.Name.Equals(name, StringComparison.Ordinal));
        if (meant is not null)
            return $": did you mean {ToolCommand.Name} {meant.Name}?";

        Verb? owner = Array.Find(verbs, verb => verb.Options.Any(other => NameOf(other.Name).Equals(name, StringComparison.Ordinal)));
        return owner is null ? "." : $": did you mean {ToolCommand.Name} {owner.Name} --{name}?";
    }

    private static string SuggestCommand(string word, Verb[] verbs)
    {
        if (word is "help" or "version")
            return $": did you mean --{word}?";
        if (Spelling.FindNearest(word, verbs.Select(static verb => verb.Name)) is { } verb)
            return $": did you mean {verb}?";

        bool isSource = word.AsSpan().ContainsAny('.', ':', '/') || File.Exists(word) || word.Equals(Source.Demo.ToString(), StringComparison.OrdinalIgnoreCase);
        return isSource ? $": did you mean {ToolCommand.Name} watch {word}?" : ".";
    }

    private static IEnumerable<string> TokensOf(CommandResult command) =>
        command.Children.OfType<ArgumentResult>().SelectMany(static argument => argument.Tokens).Select(static token => token.Value);

    // Finds an option whose value looks like another option. Without this check, a forgotten value would record to a file with an option's name.
    private static (string Option, string Value)? FindSwallowed(CommandResult command)
    {
        string[] names = [.. command.Command.Options.Select(static option => option.Name)];
        foreach (OptionResult option in command.Children.OfType<OptionResult>())
        {
            if (option.Tokens.FirstOrDefault(token => names.Contains(token.Value, StringComparer.Ordinal)) is { } token)
                return (option.Option.Name, token.Value);
        }

        return null;
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

    private static bool IsOption(string token) => token.Length > 1 && token[0] == '-';

    private static string DescribeUnknown(string unknown, Command command)
    {
        string[] names = [.. command.Options.Select(static option => option.Name)];
        if (names.Contains(unknown, StringComparer.Ordinal))
            return $"{unknown} is before the verb: write {ToolCommand.Name} {command.Name} {unknown}.";

        string? meant = Spelling.FindNearest(NameOf(unknown), names.Select(NameOf));
        return $"unknown option {unknown}{(meant is null ? "." : $": did you mean --{meant}?")}";
    }

    private static string NameOf(string option) => option.Split('=', ':')[0].TrimStart('-').ToLowerInvariant();
}
