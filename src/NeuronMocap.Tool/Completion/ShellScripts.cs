namespace NeuronMocap.Tool.Completion;

/// <summary>
/// The scripts that ask this program for completions. It answers the directive [suggest:POSITION], one word a line, for the command line that follows.
/// Where it has no answer, the shell completes names of files.
/// </summary>
internal static class ShellScripts
{
    private const string Bash = """
        # Completion of neuron-mocap for bash.
        _neuron_mocap() {
            local word=${COMP_WORDS[COMP_CWORD]}
            local IFS=$'\n'
            COMPREPLY=($(compgen -W "$(neuron-mocap "[suggest:$COMP_POINT]" "$COMP_LINE" 2> /dev/null)" -- "$word"))
        }
        complete -o default -F _neuron_mocap neuron-mocap

        """;

    private const string Zsh = """
        # Completion of neuron-mocap for zsh.
        _neuron_mocap() {
            local -a words_found
            words_found=("${(@f)$(neuron-mocap "[suggest:$CURSOR]" "$BUFFER" 2> /dev/null)}")
            if [[ -n ${words_found[1]} ]]; then
                compadd -- "${words_found[@]}"
            fi
            _files
        }
        compdef _neuron_mocap neuron-mocap

        """;

    private const string Fish = """
        # Completion of neuron-mocap for fish.
        complete -c neuron-mocap -a '(neuron-mocap "[suggest:"(commandline -C)"]" (commandline -cp) 2> /dev/null)'

        """;

    private const string PowerShell = """
        # Completion of neuron-mocap for PowerShell.
        Register-ArgumentCompleter -Native -CommandName neuron-mocap -ScriptBlock {
            param($wordToComplete, $commandAst, $cursorPosition)
            neuron-mocap "[suggest:$cursorPosition]" "$commandAst" 2> $null | ForEach-Object {
                [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_)
            }
        }

        """;

    /// <summary>The names of the shells.</summary>
    public static IReadOnlyList<string> Shells { get; } = ["bash", "zsh", "fish", "pwsh"];

    /// <summary>The script of a shell.</summary>
    public static string Of(string shell) => shell switch
    {
        "bash" => Bash,
        "zsh" => Zsh,
        "fish" => Fish,
        _ => PowerShell,
    };
}
