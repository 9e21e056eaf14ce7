using System.CommandLine;
using System.CommandLine.Help;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Commands;
using NeuronMocap.Tool.Completion;
using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Diagnose;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Info;
using NeuronMocap.Tool.Play;
using NeuronMocap.Tool.Plot;
using NeuronMocap.Tool.Relay;
using NeuronMocap.Tool.Simulate;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View;
using NeuronMocap.Tool.Watch;

namespace NeuronMocap.Tool;

/// <summary>The program: its verbs, and the handling of a command line.</summary>
internal static class CommandLine
{
    // The directive that shells send for completion. The words after it are an unfinished command line.
    private const string SuggestDirective = "[suggest";

    private static readonly string[] Default = ["watch", "demo"];

    // In the order of the help.
    private static readonly (string Name, Func<Verb> Create)[] Verbs =
    [
        ("watch", static () => new WatchVerb()),
        ("view", static () => new ViewVerb()),
        ("diagnose", static () => new DiagnoseVerb()),
        ("simulate", static () => new SimulateVerb()),
        ("relay", static () => new RelayVerb()),
        ("play", static () => new PlayVerb()),
        ("info", static () => new InfoVerb()),
        ("convert", static () => new ConvertVerb()),
        ("plot", static () => new PlotVerb()),
        ("command", static () => new CommandVerb()),
        ("completion", static () => new CompletionVerb()),
    ];

    public static async Task<int> RunAsync(IReadOnlyList<string> args, StandardStreams streams, CancellationToken cancellationToken)
    {
        IReadOnlyList<string> words = args.Count == 0 ? Default : args;
        ParseResult result;
        try
        {
            result = Create(streams, cancellationToken, words[0]).Parse(words, new ParserConfiguration { ResponseFileTokenReplacer = null });
            bool isSuggestion = words[0].StartsWith(SuggestDirective, StringComparison.Ordinal);
            bool isHelp = result is { Action: HelpPage, UnmatchedTokens.Count: 0 };
            if (!isSuggestion && !isHelp && UsageFault.Find(result, words) is { } fault)
                return await RefuseAsync(fault, streams);
        }
        catch (Exception exception)
        {
            // The parser runs this program's own checks. Their exceptions must not end in a stack trace.
            return await RefuseAsync(UsageFault.WithHelp(ToolCommand.Name, $"the options cannot be understood: {exception.Message}"), streams);
        }

        try
        {
            using var output = new StreamWriter(streams.Output, leaveOpen: true) { AutoFlush = true };
            var invocation = new InvocationConfiguration
            {
                Output = output,
                Error = streams.Error,
                EnableDefaultExceptionHandler = false,
                ProcessTerminationTimeout = null,
            };
            return await result.InvokeAsync(invocation, CancellationToken.None);
        }
        catch (IOException exception) when (StandardStreams.IsBrokenPipe(exception))
        {
            // The program that reads the output may close it at any time.
            return ToolCommand.Done;
        }
        catch (IOException exception) when (FileFault.IsDiskFull(exception))
        {
            await streams.ComplainAsync(FileFault.OfStandardOutput(exception));
            return ToolCommand.NothingReceived;
        }
        catch (Exception exception)
        {
            // An unexpected exception. The process still ends with a sentence, and the first line of the trace shows where to look.
            string? place = exception.StackTrace?.Split('\n')[0].Trim();
            await streams.ComplainAsync($"a fault of this program, please report it: {exception.GetType().Name}: {exception.Message} {place}");
            return ToolCommand.NothingReceived;
        }
    }

    /// <summary>Creates the root command.</summary>
    /// <param name="streams">The streams of the verbs.</param>
    /// <param name="cancellationToken">Ends the verbs.</param>
    /// <param name="first">The first word of the command line. If it is a verb, the others are left out, because each takes time to create.</param>
    internal static RootCommand Create(StandardStreams streams, CancellationToken cancellationToken, string? first = null)
    {
        bool isVerb = Array.Exists(Verbs, verb => verb.Name.Equals(first, StringComparison.Ordinal));
        var root = new RootCommand(ProgramHelp.Description);
        foreach ((string name, Func<Verb> create) in Verbs)
        {
            if (isVerb && !name.Equals(first, StringComparison.Ordinal))
                continue;

            Verb verb = create();
            verb.SetAction((result, _) => verb.RunAsync(result, streams, cancellationToken));
            root.Add(verb);
        }

        HelpOption help = root.Options.OfType<HelpOption>().Single();
        help.Action = new HelpPage(streams);

        // A shell that completes would take the parser's other aliases, such as /?, for folders.
        foreach (string alias in help.Aliases.Where(static alias => alias is not "-h").ToArray())
            help.Aliases.Remove(alias);

        return root;
    }

    private static async Task<int> RefuseAsync(string fault, StandardStreams streams)
    {
        await streams.ComplainAsync(fault);
        return ToolCommand.BadUsage;
    }
}
