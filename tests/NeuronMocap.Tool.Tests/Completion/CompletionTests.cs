using System.Diagnostics;
using NeuronMocap.Tests.Infrastructure;
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
    [InlineData("neuron-mocap watch --frames x --nothing-of-this", "")]
    public async Task The_program_completes_an_unfinished_command_line(string line, string words)
    {
        ToolResult result = await ToolRunner.RunAsync($"[suggest:{line.Length}]", line);

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);

        // The shells leave out what does not begin with the word.
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

    // The script in a bash whose neuron-mocap is the program that was built.
    [Theory]
    [InlineData("neuron-mocap pl", "play\nplot\n")]
    [InlineData("neuron-mocap watch --local-", "--local-address\n")]
    public async Task Bash_completes_with_its_script(string line, string words)
    {
        Assert.SkipUnless(File.Exists("/bin/bash") || File.Exists("/usr/bin/bash"), "There is no bash.");
        string script = string.Join('\n', (await ToolRunner.RunAsync("completion", "bash")).Output);
        string host = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        string test = $$"""
            neuron-mocap() { '{{host}}' '{{ToolProcess.PathOf("neuron-mocap")}}' "$@"; }
            {{script}}
            COMP_LINE='{{line}}'
            COMP_POINT=${#COMP_LINE}
            read -ra COMP_WORDS <<< "$COMP_LINE"
            COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
            _neuron_mocap
            printf '%s\n' "${COMPREPLY[@]}"
            """;
        using Process bash = Process.Start(new ProcessStartInfo("bash", ["-c", test]) { RedirectStandardOutput = true, UseShellExecute = false })!;
        string completed = await bash.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken);
        await bash.WaitForExitAsync(TestContext.Current.CancellationToken);

        Assert.Equal(0, bash.ExitCode);
        Assert.Equal(words, completed);
    }

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
