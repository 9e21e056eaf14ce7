using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class LiveViewProcessTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly FrameServer _server = FrameServer.Pacing(static number => FrameServer.Motion((uint)number, new float[354]));

    public void Dispose()
    {
        _server.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public async Task The_keys_record_freeze_explain_and_quit()
    {
        SkipWithoutTerminal();
        using var terminal = new PseudoTerminal(_folder[string.Empty], "NO_COLOR=1 TERM=xterm-256color", "watch", _server.Address, "--record", "take.nmrec");
        await terminal.WaitForAsync("> 0 Char00");
        await terminal.WaitForAsync("● REC ");
        await terminal.WaitForAsync(" stop  ");
        terminal.Press("r");
        await terminal.WaitForAsync("Recorded ");
        terminal.Press("r");
        await terminal.WaitForAsync("to take-2.nmrec");
        terminal.Press(" ");
        await terminal.WaitForAsync(" PAUSED ");
        terminal.Press("?");
        await terminal.WaitForAsync("HELP");
        terminal.Press("q");
        Assert.Equal(0, await terminal.WaitForExitAsync());

        // The terminal is restored, and then the result of each recording follows.
        string end = terminal.Text[terminal.Text.LastIndexOf("\e[?1049l", StringComparison.Ordinal)..];
        Assert.Equal(2, end.Split("neuron-mocap: recorded ").Length - 1);
        Assert.Equal(["take-2.nmrec", "take.nmrec"], _folder.Names, StringComparer.Ordinal);
        foreach (string name in _folder.Names)
        {
            using RecordingReader reader = RecordingReader.Open(_folder[name]);
            Assert.True(reader.IsComplete);
        }
    }

    [Fact]
    public async Task An_unnamed_recording_is_named_by_date_and_time()
    {
        SkipWithoutTerminal();
        using var terminal = new PseudoTerminal(_folder[string.Empty], "TERM=xterm-256color", "watch", _server.Address);
        await terminal.WaitForAsync("Char00");
        terminal.Press("r");
        await terminal.WaitForAsync("● REC ");
        terminal.Press("q");
        Assert.Equal(0, await terminal.WaitForExitAsync());
        Assert.Matches("^neuron-[0-9]{4}-[0-9]{2}-[0-9]{2}-[0-9]{6}\\.nmrec$", Assert.Single(_folder.Names));
    }

    [Fact]
    public async Task A_failed_recording_is_explained_and_the_view_goes_on()
    {
        SkipWithoutTerminal();
        DirectoryInfo gone = Directory.CreateDirectory(_folder["gone"]);
        using var terminal = new PseudoTerminal(gone.FullName, "NO_COLOR=1 TERM=xterm-256color", "watch", _server.Address);
        await terminal.WaitForAsync("> 0 Char00");
        gone.Delete();
        terminal.Press("r");
        await terminal.WaitForAsync("RECORDING FAILED: '.' does not accept new files.");
        terminal.Press("q");
        Assert.Equal(0, await terminal.WaitForExitAsync());
    }

    [Fact]
    public async Task A_terminal_without_cursor_control_gets_plain_lines()
    {
        SkipWithoutTerminal();
        (int code, string text) = await RunAsync("2.5");

        // There is a line each second. On a busy computer, the program can begin after the last one, or even receive nothing.
        if (code != 0 || !text.Contains(" Receiving ", StringComparison.Ordinal))
            (code, text) = await RunAsync("30");

        Assert.Equal(0, code);
        Assert.Contains(" Receiving  0 Char00 motion ", text, StringComparison.Ordinal);
        Assert.DoesNotContain('\e', text);

        async Task<(int Code, string Text)> RunAsync(string duration)
        {
            using var terminal = new PseudoTerminal(_folder[string.Empty], "TERM=dumb", "watch", _server.Address, "--duration", duration);
            return (await terminal.WaitForExitAsync(), terminal.Text);
        }
    }

    private static void SkipWithoutTerminal() => Assert.SkipUnless(PseudoTerminal.IsSupported, "The program 'script', which makes a terminal, is not there.");
}
