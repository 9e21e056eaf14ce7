using System.CommandLine;
using System.CommandLine.Invocation;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>The page that --help shows, for the program or for a verb.</summary>
internal sealed class HelpPage(StandardStreams streams) : SynchronousCommandLineAction
{
    private const int WidestText = 120;
    private const int WidestLabel = 34;

    private readonly TextPage _page = new(streams, WidestText);

    public override int Invoke(ParseResult parseResult)
    {
        Command command = parseResult.CommandResult.Command;
        _page.WriteLine(command.Description ?? string.Empty);
        if (command is Verb verb)
            WriteVerb(verb);
        else
            WriteProgram(command);

        return ToolCommand.Done;
    }

    private void WriteProgram(Command program)
    {
        WriteUsage("[VERB] [options]");
        WriteTitle("Verbs");
        WriteRows([.. program.Subcommands.Select(static verb => (verb.Name, verb.Description!.Split(". ")[0].TrimEnd('.') + "."))]);
        WriteTitle("Options");
        WriteRows(OwnRows(isVerb: false));
        WriteExamples(ProgramHelp.Examples);
        WriteTitle("Exit codes");
        WriteCodes(ProgramHelp.ExitCodes);
        _page.WriteLine();
        _page.WriteLine($"{ToolCommand.Name} VERB --help says more, with examples.");
    }

    private void WriteVerb(Verb verb)
    {
        string arguments = string.Concat(verb.Arguments.Select(static argument => $" {NameOf(argument)}"));
        WriteUsage($"{verb.Name}{arguments}{(verb.Sections.Count > 0 ? " [options]" : string.Empty)}");
        if (verb.Arguments.Count > 0)
        {
            WriteTitle("Arguments");
            WriteRows([.. verb.Arguments.Select(static argument => (argument.Name, argument.Description!))]);
        }

        foreach ((string title, Option[] options) in verb.Sections)
        {
            WriteTitle(title);
            WriteRows([.. options.Select(static option => (LabelOf(option), option.Description!))]);
        }

        WriteTitle("Help");
        WriteRows(OwnRows(isVerb: true));
        if (verb.Notes.Lines.Count > 0)
        {
            WriteTitle(verb.Notes.Title);
            foreach (string line in verb.Notes.Lines)
                _page.WriteRow(string.Empty, 0, line);
        }

        WriteExamples(verb.Examples);
        WriteTitle("Exit codes");
        WriteCodes([.. verb.ExitCodes, (ToolCommand.BadUsage, "wrong command line")]);
    }

    private void WriteUsage(string arguments)
    {
        WriteTitle("Usage");
        _page.WriteRow(string.Empty, 0, $"{ToolCommand.Name} {arguments}");
    }

    private void WriteTitle(string title)
    {
        _page.WriteLine();
        _page.WriteLine($"{title}:", Palette.StrongStyle);
    }

    private void WriteExamples(IReadOnlyList<HelpExample> examples)
    {
        WriteTitle("Examples");
        WriteRows([.. examples.Select(static example => ($"{ToolCommand.Name} {example.Arguments}".TrimEnd(), example.Meaning))]);
    }

    private void WriteCodes(IEnumerable<(int Code, string Meaning)> codes)
    {
        foreach ((int code, string meaning) in codes.OrderBy(static entry => entry.Code))
            _page.WriteRow($"{code}", 3, meaning, Palette.StrongStyle);
    }

    // Most labels fit into the column. A wider label gets its own line.
    private void WriteRows(IReadOnlyList<(string Label, string Text)> rows)
    {
        int width = Math.Min(rows.Max(static row => row.Label.Length), streams.IsTerminal ? WidestLabel : int.MaxValue);
        foreach ((string label, string text) in rows)
        {
            if (label.Length <= width)
            {
                _page.WriteRow(label, width, text, Palette.StrongStyle);
                continue;
            }

            _page.WriteLine($"  {label}", Palette.StrongStyle);
            _page.WriteRow(string.Empty, width, text);
        }
    }

    private static List<(string Label, string Text)> OwnRows(bool isVerb)
    {
        var rows = new List<(string, string)> { ("-h, --help", "Show this page.") };
        if (!isVerb)
            rows.Add(("--version", "Show the version."));

        return rows;
    }

    private static string NameOf(Argument argument)
    {
        string name = argument.Arity.MaximumNumberOfValues > 1 ? $"{argument.Name}..." : argument.Name;
        return argument.Arity.MinimumNumberOfValues == 0 ? $"[{name}]" : name;
    }

    private static string LabelOf(Option option)
    {
        string names = string.Join(", ", option.Aliases.Prepend(option.Name));
        return option.ValueType == typeof(bool) ? names
            : option.Arity.MinimumNumberOfValues == 0 ? $"{names} [<{option.HelpName}>]"
            : $"{names} <{option.HelpName}>";
    }
}
