using System.Diagnostics;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Completion;

public sealed class CompletionTests
{
    [Theory]
    [InlineData("neuron-mocap di", "diagnose")]
    [InlineData("neuron-mocap co", "command completion convert")]
    [InlineData("neuron-mocap watch --expo", "--export --export-avatar")]
    [InlineData("neuron-mocap watch de", "demo")]
    [InlineData("neuron-mocap convert a.bvh b.bvh --order ZY", "ZYX")]
    [InlineData("neuron-mocap simulate --format st", "studio")]
    [InlineData("neuron-mocap command studio he", "header")]
    [InlineData("neuron-mocap completion z", "zsh")]
    [InlineData("neuron-mocap watch /", "")]
    [InlineData("neuron-mocap watch -", "--allow-sender --calculation-port --command-port --duration --export --export-avatar --frames --help --json "
        + "--local-address --loop --once --order --overwrite --quiet --rate --record --record-compress --record-files --record-size --record-time --speed "
        + "--tls-name --trust -h")]
    [InlineData("neuron-mocap watch --frames x --nothing-of-this", "")]
    public async Task The_program_completes_an_unfinished_command_line(string line, string words)
    {
        ToolResult result = await ToolRunner.RunAsync($"[suggest:{line.Length}]", line);

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);

        // Shells omit suggestions that do not start with the word.
        string begun = line.Split(' ')[^1];
        Assert.Equal(
            words.Split(' ', StringSplitOptions.RemoveEmptyEntries),
            result.Output.Select(static word => word.TrimEnd()).Where(word => word.StartsWith(begun, StringComparison.Ordinal)));
    }

    [Theory]
    [InlineData("bash", "complete -o default -F")]
    [InlineData("zsh", "compdef")]
    [InlineData("fish", "complete -c neuron-mocap")]
    [InlineData("pwsh", "Register-ArgumentCompleter -Native")]
    public async Task The_script_of_every_shell_asks_the_program(string shell, string registers)
    {
        ToolResult result = await ToolRunner.RunAsync("completion", shell);

        Assert.Equal(0, result.ExitCode);
        string script = string.Join('\n', result.Output);
        Assert.Contains(registers, script, StringComparison.Ordinal);
        Assert.Contains("neuron-mocap \"[suggest:", script, StringComparison.Ordinal);
    }

    // Runs the script in a bash whose neuron-mocap is the built program.
    [Theory]
    [InlineData("neuron-mocap pl", "play\nplot\n")]
    [InlineData("neuron-mocap watch --local-", "--local-address\n")]
    public async Task Bash_completes_with_its_script(string line, string words)
    {
        string completed = await RunAsync("bash", $$"""
            COMP_LINE='{{line}}'
            COMP_POINT=${#COMP_LINE}
            read -ra COMP_WORDS <<< "$COMP_LINE"
            COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
            _neuron_mocap
            printf '%s\n' "${COMPREPLY[@]}"
            """);

        Assert.Equal(words, completed);
    }

    // The functions of compinit exist only on a terminal. These replacements show what the script passes to them.
    [Theory]
    [InlineData("play:plot:files:", "pl")]
    [InlineData("--local-address:files:", "watch", "--local-")]
    [InlineData("tcp://:files:", "watch", "tc")]
    [InlineData("files:", "info", "nothing-that-is-there")]
    public async Task Zsh_completes_with_its_script(string words, params string[] typed)
    {
        string completed = await RunAsync("zsh", $$"""
            words=(neuron-mocap {{string.Join(' ', typed)}})
            CURRENT={{typed.Length + 1}}
            PREFIX={{typed[^1]}}
            BUFFER="ls; $words"
            CURSOR=$#BUFFER
            _neuron_mocap
            """, before: """
            compdef() { }
            compadd() { while [[ $1 != -- ]] { shift }; shift; for word in $@; do [[ $word == $PREFIX* ]] && print -n -- "$word:"; done }
            _files() { print -n files: }
            """);

        Assert.Equal(words, completed);
    }

    [Theory]
    [InlineData("neuron-mocap pl", "play\nplot\n")]
    [InlineData("neuron-mocap watch --local-", "--local-address\n")]
    [InlineData("ls | neuron-mocap com", "command\ncompletion\n")]
    [InlineData("neuron-mocap command studio ze", "zero-out\n")]
    public async Task Fish_completes_with_its_script(string line, string words) =>
        Assert.Equal(words, await RunAsync("fish", $"complete -C '{line}'"));

    // Runs a script after that of the shell.
    private static async Task<string> RunAsync(string shell, string script, string before = "")
    {
        Assert.SkipUnless(InstalledPrograms.Have(shell), $"There is no {shell}.");
        string completion = string.Join('\n', (await ToolRunner.RunAsync("completion", shell)).Output);
        string host = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        string program = $"'{host}' '{ToolProcess.PathOf("neuron-mocap")}'";
        string function = shell == "fish" ? $"function neuron-mocap; {program} $argv; end" : $"neuron-mocap() {{ {program} \"$@\"; }}";
        var start = new ProcessStartInfo(shell, [NoStartFiles(shell), "-c", string.Join('\n', before, function, completion, script)])
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            UseShellExecute = false,
        };
        using Process process = Process.Start(start)!;
        Task<string> errors = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        string output = await process.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken);
        await process.WaitForExitAsync(TestContext.Current.CancellationToken);
        Assert.Empty(await errors);
        return output;
    }

    private static string NoStartFiles(string shell) => shell switch
    {
        "bash" => "--norc",
        "zsh" => "-f",
        _ => "--no-config",
    };

    [Fact]
    public void The_page_of_the_program_names_every_verb_and_every_exit_code()
    {
        string page = File.ReadAllText(Repository.PathOf("docs/reference/cli.md"));
        using var streams = new StandardStreams(Stream.Null, TextWriter.Null, IsTerminal: false);
        Assert.All(CommandLine.Create(streams, CancellationToken.None).Subcommands.OfType<Verb>(), verb =>
        {
            Assert.Contains($"| `{verb.Name}", page, StringComparison.Ordinal);
            Assert.All(verb.ExitCodes, entry => Assert.Contains($"\n| {entry.Code} | ", page, StringComparison.Ordinal));
        });
    }
}
