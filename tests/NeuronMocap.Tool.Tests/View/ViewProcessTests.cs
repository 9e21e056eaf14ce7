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
        await using RunningView first = await RunningView.StartAsItIsAsync("demo");
        await using RunningView second = await RunningView.StartAsItIsAsync("demo");
        Assert.NotEqual(first.Link.Port, second.Link.Port);
        Assert.Equal((0, 0), (await first.StopAsync(), await second.StopAsync()));
        Assert.Contains("is in use, perhaps by another viewer", first.Error + second.Error, StringComparison.Ordinal);
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

    [Theory]
    [InlineData(2, "--record-folder needs a stream", "--record-folder", ".")]
    [InlineData(1, "--order: walk.bvh does not need it", "--order", "XYZ")]
    public async Task A_file_refuses_the_options_of_streams(int code, string expected, params string[] options)
    {
        ToolResult result = await ToolRunner.RunAsync(["view", Repository.PathOf("samples", "takes", "walk.bvh"), "--port", "0", .. options]);
        Assert.Equal(code, result.ExitCode);
        Assert.Contains(expected, Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_temporary_folder_that_does_not_exist_is_one_line()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows finds another folder.");
        using var view = new ToolProcess(("TMPDIR", _folder["missing"]), "neuron-mocap", ["view", "demo", "--port", "0"]);
        Assert.Equal(1, await view.WaitForExitAsync());
        string line = Assert.Single((await view.ReadErrorAsync()).Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.StartsWith($"neuron-mocap: The folder for temporary files, '{_folder["missing"]}", line, StringComparison.Ordinal);
        Assert.Contains("TMPDIR", line, StringComparison.Ordinal);
    }

    // A terminal wraps a long line itself. A line break in a link would cut what people click and copy.
    [Fact]
    public async Task A_link_is_one_line_on_a_small_terminal()
    {
        string token = new('t', 60);
        ToolResult result = await ToolRunner.RunOnTerminalAsync(50, "view", "demo", "--port", "0", "--duration", "0.1", "--token", token);
        Assert.Contains(result.Output, line => line.Contains($"?token={token}", StringComparison.Ordinal));
    }

    [Fact]
    public async Task The_browser_survives_the_end_of_the_program()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux() && InstalledPrograms.PathOf("setsid") is not null, "There is no setsid on the PATH.");
        string browser = _folder.Write("xdg-open", $"#!/bin/sh\nread -r line < /proc/$$/stat\necho \"$line\" > '{_folder["opened"]}.new' && /bin/mv '{_folder["opened"]}.new' '{_folder["opened"]}'\n");
        if (OperatingSystem.IsLinux())
            File.SetUnixFileMode(browser, UnixFileMode.UserRead | UnixFileMode.UserExecute);
        using var view = new ToolProcess(("PATH", $"{_folder[string.Empty]}:{Environment.GetEnvironmentVariable("PATH")}"), "neuron-mocap", ["view", "demo", "--port", "0", "--open", "--duration", "60"]);
        await ReadLinkAsync(view);
        await Limits.UntilAsync(() => File.Exists(_folder["opened"]));
        Assert.NotEqual(SessionOf(await File.ReadAllTextAsync($"/proc/{view.Id}/stat", TestContext.Current.CancellationToken)), SessionOf(await File.ReadAllTextAsync(_folder["opened"], TestContext.Current.CancellationToken)));
        view.Kill();
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

    // The fourth word after the name, which stands in brackets.
    private static string SessionOf(string stat) => stat[(stat.LastIndexOf(')') + 2)..].Split(' ')[3];

    private static Task<ViewSocket> ConnectAsync(Uri link, string path) =>
        ViewSocket.ConnectAsync(new UriBuilder(link) { Scheme = "ws", Path = path }.Uri, path == "/motion" ? "pose" : null, configure: null);

    private static async Task<Uri> ReadLinkAsync(ToolProcess view)
    {
        string? line = await view.Output.ReadLineAsync(TestContext.Current.CancellationToken).Soon();
        Assert.StartsWith(Start, line, StringComparison.Ordinal);
        return new Uri(line![Start.Length..]);
    }
}
