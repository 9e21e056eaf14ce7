using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Terminal;

/// <summary>The visible screen of a terminal.</summary>
public sealed class TmuxTests
{
    private const string NoTmux = "There is no tmux.";

    [Fact]
    public async Task The_simulator_shows_its_state_below_its_output()
    {
        Assert.SkipUnless(TmuxTerminal.Exists, NoTmux);
        await using TmuxTerminal terminal = await TmuxTerminal.StartAsync(100, 12, "simulate --port 0");

        string[] begun = await terminal.WaitForAsync(static lines => lines.Any(static line => line.StartsWith("0 clients, ", StringComparison.Ordinal)));
        using var client = new TcpClient();
        await client.ConnectAsync(IPEndPoint.Parse(begun[1]["Listening on ".Length..]), TestContext.Current.CancellationToken);

        // Drawn again, with the changes.
        string[] shown = await terminal.WaitForAsync(static lines => lines.Any(IsProgress));
        Assert.StartsWith("Broadcasting synthetic actor", shown[0], StringComparison.Ordinal);
        Assert.StartsWith("Listening on 127.0.0.1:", shown[1], StringComparison.Ordinal);
        Assert.Equal("Ctrl+C ends the program.", shown[2]);
        Assert.Single(shown, IsProgress);

        await terminal.TypeAsync("C-c");
        string[] ended = await terminal.WaitForAsync(static lines => lines.Contains("ended with 0"));
        Assert.StartsWith("Listening on 127.0.0.1:", ended[1], StringComparison.Ordinal);
        Assert.StartsWith("Served 1 client: ", ended[3], StringComparison.Ordinal);

        static bool IsProgress(string line) => line.StartsWith("1 client, ", StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_program_alone_shows_a_skeleton_until_q()
    {
        Assert.SkipUnless(TmuxTerminal.Exists, NoTmux);
        await using TmuxTerminal terminal = await TmuxTerminal.StartAsync(80, 24, string.Empty);

        string[] shown = await terminal.WaitForAsync(static lines => lines.Any(static line => line.Contains("L.Foot", StringComparison.Ordinal)));
        Assert.Contains("RECEIVING", shown[0], StringComparison.Ordinal);
        Assert.Contains("demo", shown[0], StringComparison.Ordinal);

        await terminal.TypeAsync("q");
        await terminal.WaitForAsync(static lines => lines.Contains("ended with 0"));
    }

    [Fact]
    public async Task Help_is_wrapped_to_the_terminal()
    {
        Assert.SkipUnless(TmuxTerminal.Exists, NoTmux);
        await using TmuxTerminal terminal = await TmuxTerminal.StartAsync(60, 60, "command --help");

        string[] shown = await terminal.WaitForAsync(static lines => lines.Contains("ended with 0"));
        Assert.Contains("Examples:", shown);
        Assert.All(shown.Where(static line => line.Length > 50), static line => Assert.True(line.Length <= 60, line));
    }
}
