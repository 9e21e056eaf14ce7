using System.Net;
using System.Net.Sockets;
using System.Net.WebSockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.View;

// Runs of view as its own process.
public sealed class ViewProcessTests : IDisposable
{
    private const string Start = "Viewing demo on ";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task An_interrupt_ends_it_with_pages_open_and_leaves_no_files()
    {
        ToolProcess.SkipWithoutInterrupt();
        using var view = new ToolProcess(("TMPDIR", _folder[string.Empty]), "neuron-mocap", ["view", "demo", "--port", "0"]);
        Uri link = await ReadLinkAsync(view);
        using ViewSocket control = await ConnectAsync(link, "/control");
        using ViewSocket motion = await ConnectAsync(link, "/motion");
        await control.FindAsync("performer");
        Assert.NotEmpty(Directory.GetDirectories(_folder[string.Empty], "neuron-mocap-view-*"));
        view.Interrupt();
        while (await control.ReceiveAsync() is not null)
        {
        }

        Assert.Equal(WebSocketCloseStatus.EndpointUnavailable, control.CloseStatus);
        Assert.Equal(0, await view.WaitForExitAsync());
        Assert.Empty(Directory.GetDirectories(_folder[string.Empty], "neuron-mocap-view-*"));
        Assert.DoesNotContain("at NeuronMocap", await view.ReadErrorAsync(), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_browser_that_does_not_start_is_one_line()
    {
        ToolProcess.SkipWithoutInterrupt();
        using var view = new ToolProcess(("PATH", _folder[string.Empty]), "neuron-mocap", ["view", "demo", "--port", "0", "--open", "--duration", "0.1"]);
        Uri link = await ReadLinkAsync(view);
        Assert.Equal(0, await view.WaitForExitAsync());
        string[] lines = (await view.ReadErrorAsync()).Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Contains($"neuron-mocap: --open: no browser could be started. Open {link} yourself.", lines);
    }

    [Fact]
    public async Task The_browser_gets_the_link()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "The program of other systems cannot be replaced.");
        ToolProcess.SkipWithoutInterrupt();
        string browser = _folder.Write("xdg-open", $"#!/bin/sh\necho \"$1\" > '{_folder["opened"]}.new' && /bin/mv '{_folder["opened"]}.new' '{_folder["opened"]}'\n");
        if (OperatingSystem.IsLinux())
            File.SetUnixFileMode(browser, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        using var view = new ToolProcess(("PATH", _folder[string.Empty]), "neuron-mocap", ["view", "demo", "--port", "0", "--open", "--token", "word"]);
        Uri link = await ReadLinkAsync(view);
        await Limits.UntilAsync(() => File.Exists(_folder["opened"]));
        Assert.Equal($"{link}\n", await File.ReadAllTextAsync(_folder["opened"], TestContext.Current.CancellationToken));
        Assert.Equal("?token=word", link.Query);
        view.Interrupt();
        Assert.Equal(0, await view.WaitForExitAsync());
    }

    [Fact]
    public async Task A_given_port_that_is_taken_is_one_line()
    {
        using var other = new TcpListener(IPAddress.Loopback, 0);
        other.Start();
        int port = ((IPEndPoint)other.LocalEndpoint).Port;
        ToolResult result = await ToolRunner.RunAsync("view", "demo", "--port", $"{port}");
        Assert.Equal(1, result.ExitCode);
        Assert.StartsWith($"neuron-mocap: --port: port {port} on 127.0.0.1 is in use by another program; ", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Without_a_port_two_viewers_get_different_ones()
    {
        // The default port may be taken by anything on this computer.
        ToolResult[] results = await Task.WhenAll(
            ToolRunner.RunAsync("view", "demo", "--duration", "3"),
            ToolRunner.RunAsync("view", "demo", "--duration", "3"));
        Assert.All(results, static result => Assert.Equal(0, result.ExitCode));
        Assert.NotEqual(PortOf(results[0]), PortOf(results[1]));
        Assert.Contains(results, static result => Array.Exists(result.Error, static line => line.Contains("is in use, perhaps by another viewer", StringComparison.Ordinal)));
    }

    [Theory]
    [InlineData("--token: use letters, digits and -._~ only", "view", "--token", "a b")]
    [InlineData("--port: '70000' is not a number from 0 to 65535.", "view", "--port", "70000")]
    [InlineData("--bind: 'everywhere' is not an IP address.", "view", "--bind", "everywhere")]
    [InlineData("--record-folder: there is no folder 'missing'.", "view", "--record-folder", "missing")]
    [InlineData("--allow-origin: '*' is not an origin.", "view", "--allow-origin", "*")]
    [InlineData("--allow-origin: 'show.example' is not an origin.", "view", "--allow-origin", "show.example")]
    [InlineData("--upload-limit", "view", "--upload-limit", "0")]
    [InlineData("--command-port needs a source HOST or tcp://HOST:PORT", "view", "demo", "--command-port", "8013")]
    public async Task A_wrong_option_is_one_line(string expected, params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync(args);
        Assert.Equal(2, result.ExitCode);
        Assert.Contains(expected, Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_address_of_another_computer_is_one_line()
    {
        ToolResult result = await ToolRunner.RunAsync("view", "demo", "--bind", "192.0.2.1", "--port", $"{FreePort.Next()}");
        Assert.Equal(1, result.ExitCode);
        Assert.StartsWith("neuron-mocap: --bind: this computer cannot listen on 192.0.2.1", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_terminal_shows_the_link_as_a_QR_code_for_other_computers_only()
    {
        ToolResult result = await ToolRunner.RunOnTerminalAsync(100, "view", "demo", "--port", "0", "--duration", "0.1", "--bind", "0.0.0.0");
        string[] links = [.. result.Output.Where(static line => line.Contains("From other computers and phones: http://", StringComparison.Ordinal))];
        Assert.Equal(links.Length > 0, result.Output.Any(static line => line.Contains('▀', StringComparison.Ordinal)));
        result = await ToolRunner.RunOnTerminalAsync(100, "view", "demo", "--port", "0", "--duration", "0.1");
        Assert.DoesNotContain(result.Output, static line => line.Contains('▀', StringComparison.Ordinal) || line.Contains("token", StringComparison.Ordinal));
    }

    private static int PortOf(ToolResult result) => new Uri(result.Output[0][Start.Length..]).Port;

    private static Task<ViewSocket> ConnectAsync(Uri link, string path) =>
        ViewSocket.ConnectAsync(new UriBuilder(link) { Scheme = "ws", Path = path }.Uri, path == "/motion" ? "pose" : null, configure: null);

    private static async Task<Uri> ReadLinkAsync(ToolProcess view)
    {
        string? line = await view.Output.ReadLineAsync(TestContext.Current.CancellationToken).Soon();
        Assert.StartsWith(Start, line, StringComparison.Ordinal);
        return new Uri(line![Start.Length..]);
    }
}
