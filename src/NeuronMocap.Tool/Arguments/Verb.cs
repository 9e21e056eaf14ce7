using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>A command line to type, and what it does.</summary>
/// <param name="Arguments">What stands behind the name of the program.</param>
/// <param name="Meaning">What it does, in a line.</param>
internal sealed record HelpExample(string Arguments, string Meaning);

/// <summary>One of the things that the program does, with its options, its examples and its exit codes.</summary>
internal abstract class Verb : Command
{
    private readonly List<(string Title, Option[] Options)> _sections = [];

    protected Verb(string name, string description)
        : base(name, description)
    {
    }

    /// <summary>The options in the order of the help, under a title each.</summary>
    public IReadOnlyList<(string Title, Option[] Options)> Sections => _sections;

    /// <summary>What to type.</summary>
    public abstract IReadOnlyList<HelpExample> Examples { get; }

    /// <summary>What the exit codes mean, apart from 2, which means the same everywhere.</summary>
    public abstract IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; }

    /// <summary>Lines that only this verb's help has, under a title; empty for none.</summary>
    public virtual (string Title, IReadOnlyList<string> Lines) Notes => (string.Empty, []);

    /// <summary>Does it.</summary>
    /// <param name="result">A command line without errors.</param>
    /// <param name="streams">Where to write.</param>
    /// <param name="cancellationToken">Ctrl+C, and whatever else ends the program.</param>
    /// <returns>The exit code.</returns>
    public abstract Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken);

    /// <summary>Whether an option stands on the command line.</summary>
    public static bool IsGiven(CommandResult result, Option option) => result.GetResult(option) is { Implicit: false };

    protected void AddOptions(string title, params Option[] options)
    {
        foreach (Option option in options)
        {
            if (option.ValueType == typeof(bool))
                option.Arity = ArgumentArity.Zero;

            Add(option);
        }

        _sections.Add((title, options));
    }

    /// <summary>Says what is wrong with values that are each right by themselves.</summary>
    protected async Task<int> RefuseAsync(StandardStreams streams, string fault)
    {
        await streams.ComplainAsync(UsageFault.WithHelp($"{CommandLine.Name} {Name}", fault));
        return CommandLine.BadUsage;
    }

    /// <summary>Adds an error for each given option out of two that contradict each other.</summary>
    public static void RejectBoth(CommandResult result, Option one, Option other)
    {
        if (IsGiven(result, one) && IsGiven(result, other))
            result.AddError($"{one.Name} and {other.Name} exclude each other.");
    }
}
