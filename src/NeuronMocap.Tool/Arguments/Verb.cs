using System.CommandLine;
using System.CommandLine.Parsing;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Arguments;

/// <summary>An example of a command line.</summary>
/// <param name="Arguments">The arguments after the name of the program.</param>
/// <param name="Meaning">Its effect, in one line.</param>
internal sealed record HelpExample(string Arguments, string Meaning);

/// <summary>A verb of the program, with its options, examples and exit codes.</summary>
internal abstract class Verb : Command
{
    private readonly List<(string Title, Option[] Options)> _sections = [];

    protected Verb(string name, string description)
        : base(name, description)
    {
    }

    /// <summary>The options in the order of the help, grouped under titles.</summary>
    public IReadOnlyList<(string Title, Option[] Options)> Sections => _sections;

    /// <summary>Examples of the verb.</summary>
    public abstract IReadOnlyList<HelpExample> Examples { get; }

    /// <summary>The meaning of the exit codes, except 2, which is the same for all verbs.</summary>
    public abstract IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; }

    /// <summary>Additional lines in the help of this verb, under a title. Empty for none.</summary>
    public virtual (string Title, IReadOnlyList<string> Lines) Notes => (string.Empty, []);

    /// <summary>Runs the verb.</summary>
    /// <param name="result">A command line without errors.</param>
    /// <param name="streams">The streams to write to.</param>
    /// <param name="cancellationToken">Cancelled by Ctrl+C and by anything else that ends the program.</param>
    /// <returns>The exit code.</returns>
    public abstract Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken);

    /// <summary>Whether the command line contains an option.</summary>
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

    /// <summary>Reports a fault of values that are valid separately but not together.</summary>
    protected async Task<int> RefuseAsync(StandardStreams streams, string fault)
    {
        await streams.ComplainAsync(UsageFault.WithHelp($"{ToolCommand.Name} {Name}", fault));
        return ToolCommand.BadUsage;
    }

    /// <summary>Adds an error if the command line contains both of two options that exclude each other.</summary>
    public static void RejectBoth(CommandResult result, Option one, Option other)
    {
        if (IsGiven(result, one) && IsGiven(result, other))
            result.AddError($"{one.Name} and {other.Name} exclude each other.");
    }
}
