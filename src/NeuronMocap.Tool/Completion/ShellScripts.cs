namespace NeuronMocap.Tool.Completion;

/// <summary>The scripts with which shells ask this program for completions.</summary>
/// <remarks>
/// The program answers the directive [suggest:POSITION] for the command line that follows, one word a line. If it has no answer, the shell completes
/// file names.
/// </remarks>
internal static class ShellScripts
{
    private const string Bash = """
        # Completion of neuron-mocap for bash.
        _neuron_mocap() {
            local word=${COMP_WORDS[COMP_CWORD]}
            local IFS=$'\n'
            COMPREPLY=($(compgen -W "$(neuron-mocap "[suggest:$COMP_POINT]" "$COMP_LINE" 2> /dev/null)" -- "$word"))
            if [[ ${COMPREPLY[*]} == *[:/] ]]; then
                compopt -o nospace 2> /dev/null
            fi
        }
        complete -o default -F _neuron_mocap neuron-mocap

        """;

    // $words holds only this command, while $BUFFER holds the whole line. PREFIX ends at the cursor.
    private const string Zsh = """
        # Completion of neuron-mocap for zsh.
        _neuron_mocap() {
            local line="neuron-mocap ${(j: :)words[2,CURRENT-1]} $PREFIX"
            local -a found
            found=("${(@f)$(neuron-mocap "[suggest:${#line}]" "$line" 2> /dev/null)}")
            compadd -S '' -- ${(M)found:#*[:/]}
            compadd -- ${found:#*[:/]}
            _files
        }
        compdef _neuron_mocap neuron-mocap

        """;

    // -p is this command of the line, -c the text before the cursor.
    private const string Fish = """
        # Completion of neuron-mocap for fish.
        function __neuron_mocap_complete
            set -l line (commandline -cp | string join ' ' | string trim --left)
            neuron-mocap "[suggest:"(string length -- $line)"]" $line 2> /dev/null
        end
        complete -c neuron-mocap -a '(__neuron_mocap_complete)'

        """;

    // The command comes without trailing spaces. The cursor position counts from the start of the line.
    private const string PowerShell = """
        # Completion of neuron-mocap for PowerShell.
        Register-ArgumentCompleter -Native -CommandName neuron-mocap -ScriptBlock {
            param($wordToComplete, $commandAst, $cursorPosition)
            $length = $cursorPosition - $commandAst.Extent.StartOffset
            $line = $commandAst.Extent.Text.PadRight($length).Substring(0, $length)
            neuron-mocap "[suggest:$length]" $line 2> $null | Where-Object { $_ -like "$wordToComplete*" } | ForEach-Object {
                [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_)
            }
        }

        """;

    /// <summary>The names of the shells.</summary>
    public static IReadOnlyList<string> Shells { get; } = ["bash", "zsh", "fish", "pwsh"];

    /// <summary>Gets the script of a shell.</summary>
    public static string Of(string shell) => shell switch
    {
        "bash" => Bash,
        "zsh" => Zsh,
        "fish" => Fish,
        _ => PowerShell,
    };
}
