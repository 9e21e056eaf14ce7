using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The one line that a wrong command line is answered with.</summary>
internal static class UsageFault
{
    // Of two letters in three that are the same nobody means another word.
    private const int LettersPerSlip = 3;

    /// <summary>Finds what is wrong.</summary>
    /// <param name="result">The command line.</param>
    /// <param name="program">The name of the program, whose help is pointed to.</param>
    /// <param name="source">The argument that takes what no option does; null for a program without one.</param>
    /// <returns>A sentence and where help is; null when nothing is wrong.</returns>
    public static string? Find(ParseResult result, string program, Argument? source = null)
    {
        string[] leftOver = [.. TokensOf(result, source), .. result.UnmatchedTokens];
        if (leftOver.FirstOrDefault(IsOption) is { } unknown)
            return WithHelp(program, $"unknown option {unknown}{Suggest(unknown, result.CommandResult.Command.Options)}");
        if (FindSwallowed(result.CommandResult) is { } swallowed)
            return WithHelp(program, $"{swallowed.Option} needs a value, and {swallowed.Value} is another option.");
        if (result.UnmatchedTokens.Count > 0)
            return WithHelp(program, $"'{result.UnmatchedTokens[0]}' is one word too many{(source is null ? "." : ": there is one source.")}");

        return result.Errors.Count > 0 ? WithHelp(program, result.Errors[0].Message) : null;
    }

    /// <summary>The sentence, on one line, and where help is.</summary>
    public static string WithHelp(string program, string fault) => $"{TerminalText.Clean(fault)} {program} --help lists the options.";

    private static IEnumerable<string> TokensOf(ParseResult result, Argument? source) =>
        source is null ? [] : result.GetResult(source)?.Tokens.Select(static token => token.Value) ?? [];

    // Who forgets a value would otherwise record to a file that is named like the next option.
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

    private static bool IsOption(string token) => token.Length > 1 && token[0] == '-';

    private static string Suggest(string unknown, IEnumerable<Option> options)
    {
        string word = NameOf(unknown);
        (string Name, int Slips) best = options
            .Select(option => (option.Name, Slips: CountSlips(word, NameOf(option.Name))))
            .OrderBy(static candidate => candidate.Slips)
            .ThenBy(static candidate => candidate.Name, StringComparer.Ordinal)
            .First();
        return best.Slips <= Math.Max(1, word.Length / LettersPerSlip) ? $": did you mean {best.Name}?" : ".";
    }

    private static string NameOf(string option) => option.Split('=', ':')[0].TrimStart('-').ToLowerInvariant();

    // Letters to change, add or leave out; the beginning of a word is as good as the word.
    private static int CountSlips(string typed, string name)
    {
        if (typed.Length > 1 && name.StartsWith(typed, StringComparison.Ordinal))
            return 1;

        int[] row = [.. Enumerable.Range(0, name.Length + 1)];
        for (int i = 0; i < typed.Length; i++)
        {
            int diagonal = row[0];
            row[0] = i + 1;
            for (int j = 0; j < name.Length; j++)
            {
                int changed = diagonal + (typed[i] == name[j] ? 0 : 1);
                diagonal = row[j + 1];
                row[j + 1] = Math.Min(changed, Math.Min(diagonal, row[j]) + 1);
            }
        }

        return row[^1];
    }
}
