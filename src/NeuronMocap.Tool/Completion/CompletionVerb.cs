using System.CommandLine;
using System.Text;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Completion;

/// <summary>neuron-mocap completion: prints the script with which a shell completes this program's verbs and options.</summary>
internal sealed class CompletionVerb : Verb
{
    private readonly Argument<string> _shell = new("SHELL")
    {
        Description = $"The shell: {string.Join(", ", ShellScripts.Shells)}.",
        Arity = ArgumentArity.ExactlyOne,
        CustomParser = static result =>
        {
            string shell = result.Tokens[0].Value;
            if (!ShellScripts.Shells.Contains(shell, StringComparer.Ordinal))
                result.AddError($"'{shell}' is not one of {string.Join(", ", ShellScripts.Shells)}.");

            return shell;
        },
    };

    public CompletionVerb()
        : base("completion", "Print a script that makes a shell complete verbs, options and files with the tab key.")
    {
        _shell.CompletionSources.Add([.. ShellScripts.Shells]);
        Add(_shell);
    }

    public override IReadOnlyList<HelpExample> Examples { get; } =
    [
        new("completion bash >> ~/.bashrc", "for bash, from the next shell on"),
        new("completion zsh >> ~/.zshrc", "for zsh, after compinit"),
        new("completion fish > ~/.config/fish/completions/neuron-mocap.fish", "for fish"),
        new("completion pwsh >> $PROFILE", "for PowerShell"),
    ];

    public override IReadOnlyList<(int Code, string Meaning)> ExitCodes { get; } = [(ToolCommand.Done, "done")];

    public override async Task<int> RunAsync(ParseResult result, StandardStreams streams, CancellationToken cancellationToken)
    {
        await streams.Output.WriteAsync(Encoding.UTF8.GetBytes(ShellScripts.Of(result.GetValue(_shell)!)), CancellationToken.None);
        await streams.Output.FlushAsync(CancellationToken.None);
        return ToolCommand.Done;
    }
}
