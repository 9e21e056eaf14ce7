using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Simulate;

public sealed class SimulatorProcessTests
{
    private const string Program = "neuron-mocap simulate";
    private const string Listening = "Listening on ";

    [Theory]
    [InlineData("--rate", "fast")]
    [InlineData("--avatars", "0")]
    [InlineData("--order", "YYX")]
    [InlineData("--fragment", "0")]
    [InlineData("--bvh", "take.bvh", "--synthetic")]
    [InlineData("--calc", "take.calc", "--bvh", "take.bvh")]
    [InlineData("--format", "csv")]
    [InlineData("--format", "text", "--header", "old")]
    [InlineData("--format", "text", "--header", "new")]
    [InlineData("--format", "studio", "--header", "old")]
    [InlineData("--decimals", "3")]
    [InlineData("--format", "text", "--decimals", "7")]
    [InlineData("--data-commands", "perhaps")]
    [InlineData("--command-port", "65536")]
    [InlineData("--command-port", "7001")]
    [InlineData("--command-port", "--port", "8013")]
    [InlineData("--calculation-port", "65536")]
    [InlineData("--calculation-port", "--port", "7003")]
    [InlineData("--calculation-port", "--command-port", "7003")]
    [InlineData("--calculation-port", "--motion", "off")]
    [InlineData("--calculation-port", "0", "--udp", "127.0.0.1:7002")]
    [InlineData("--motion", "perhaps")]
    [InlineData("--unknown")]
    [InlineData("studio")]
    public async Task Bad_usage_is_one_line_that_says_where_help_is_and_ends_with_2(params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync(["simulate", .. args]);
        Assert.Equal(2, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: ", line, StringComparison.Ordinal);
        Assert.EndsWith(" neuron-mocap simulate --help lists the options.", line.TrimEnd(), StringComparison.Ordinal);
    }

    // Covers every option that --help lists, so that new options are tested too.
    [Fact]
    public async Task Every_option_with_a_wrong_or_a_second_value_is_one_line_and_ends_with_2()
    {
        string[] help = (await ToolRunner.RunAsync("simulate", "--help")).Output;
        string[] options = [.. help.Where(static line => line.StartsWith("  --", StringComparison.Ordinal) && line.Contains('<', StringComparison.Ordinal)).Select(static line => line.Split(' ', ',')[2])];
        Assert.True(options.Length > 15, "The options are not found in the help.");
        foreach (string option in options)
        {
            // A file may have any name, and a destination may be repeated.
            bool isFile = option is "--bvh" or "--calc" or "--play";
            string[][] commands = isFile ? [[option, "x", option, "x"]] : option is "--udp" ? [[option, "x"]] : [[option, "x"], [option, "x", option, "x"]];
            foreach (string[] args in commands)
            {
                ToolResult result = await ToolRunner.RunAsync(["simulate", .. args]);
                Assert.True(result.ExitCode == 2, string.Join(' ', args));
                Assert.Contains(option, Assert.Single(result.Error), StringComparison.Ordinal);
            }
        }
    }

    [Fact]
    public async Task An_unknown_option_is_reported_with_a_suggestion()
    {
        using var simulator = new ToolProcess(Program, "--avatar", "2");
        Assert.Equal(2, await simulator.WaitForExitAsync());
        Assert.Contains("unknown option --avatar: did you mean --avatars?", await simulator.ReadErrorAsync(), StringComparison.Ordinal);
    }

    [Fact]
    public async Task UDP_alone_counts_no_clients()
    {
        using var simulator = new ToolProcess(Program, "--udp", "127.0.0.1:9", "--frames", "2");
        string report = await simulator.Output.ReadToEndAsync(TestContext.Current.CancellationToken);
        Assert.Equal(0, await simulator.WaitForExitAsync());
        Assert.Contains("\n2 frames sent, ", report, StringComparison.Ordinal);
        Assert.DoesNotContain("client", report, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_port_in_use_ends_with_1_and_one_line_that_names_the_option()
    {
        using var other = new TcpListener(IPAddress.Loopback, 0);
        other.Start();
        int port = ((IPEndPoint)other.LocalEndpoint).Port;
        await AssertFailsAsync("--port", "--port", $"{port}");
    }

    [Fact]
    public async Task A_command_port_in_use_ends_with_1_and_one_line_that_names_the_option()
    {
        using var other = new TcpListener(IPAddress.Loopback, 0);
        other.Start();
        await AssertFailsAsync("--command-port", "--port", "0", "--command-port", $"{((IPEndPoint)other.LocalEndpoint).Port}");
    }

    [Fact]
    public async Task The_command_channel_is_announced_and_answers_watch()
    {
        using var simulator = new ToolProcess(Program, "--port", "0", "--command-port", "0", "--order", "XZY");
        await ReadAddressAsync(simulator);
        string? line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        Assert.StartsWith("Commands on ", line, StringComparison.Ordinal);
        using var monitor = new ToolProcess("neuron-mocap", "command", line!["Commands on ".Length..], "--json");
        string answer = await monitor.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.Contains("\"rotationOrder\":\"XZY\"", answer, StringComparison.Ordinal);
        Assert.Equal(0, await monitor.WaitForExitAsync());
    }

    [Fact]
    public async Task A_missing_file_ends_with_1_and_one_line_that_names_the_option() =>
        await AssertFailsAsync("--bvh", "--bvh", Path.Combine(Path.GetTempPath(), Path.GetRandomFileName()));

    [Fact]
    public async Task An_invalid_take_ends_with_1_and_one_line_that_names_the_option() =>
        await AssertFailsAsync("--bvh", "--bvh", typeof(SimulatorProcessTests).Assembly.Location);

    [Theory]
    [InlineData("--bvh")]
    [InlineData("--calc")]
    [InlineData("--play")]
    public async Task A_folder_in_place_of_a_file_is_reported(string option)
    {
        string folder = Path.GetTempPath();
        Assert.Contains("is a folder", await FailAsync(option, folder), StringComparison.Ordinal);
        Assert.Contains("does not exist", await FailAsync(option, Path.Combine(folder, Path.GetRandomFileName())), StringComparison.Ordinal);
        string empty = Path.GetTempFileName();
        Assert.Contains("is empty", await FailAsync(option, empty), StringComparison.Ordinal);
        File.Delete(empty);
        if (OperatingSystem.IsWindows())
            return;

        Assert.Contains("device", await FailAsync(option, "/dev/zero"), StringComparison.Ordinal);
        string pipe = Path.Combine(folder, Path.GetRandomFileName());
        using (Process make = Process.Start("mkfifo", [pipe]))
            await make.WaitForExitAsync(TestContext.Current.CancellationToken);

        string link = pipe + ".bvh";
        File.CreateSymbolicLink(link, pipe);
        Assert.Contains("a pipe", await FailAsync(option, pipe), StringComparison.Ordinal);
        Assert.Contains("a pipe", await FailAsync(option, link), StringComparison.Ordinal);
        File.Delete(link);
        File.Delete(pipe);
    }

    [Fact]
    public async Task A_foreign_address_is_reported_as_an_option_of_the_program() =>
        await AssertFailsAsync("--bind", "--bind", "192.0.2.1", "--port", "0");

    [Fact]
    public async Task Help_names_ports_and_unsuitable_clients()
    {
        using var simulator = new ToolProcess(Program, "--help");
        string help = string.Join(' ', (await simulator.Output.ReadToEndAsync(TestContext.Current.CancellationToken)).Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
        Assert.Contains("--calculation-port", help, StringComparison.Ordinal);
        Assert.Contains("Default without PORT: 7003.", help, StringComparison.Ordinal);
        Assert.Contains("b12 library crash on the packets of Axis Studio", help, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Frames_of_all_avatars_reach_watch_and_both_programs_end()
    {
        using var simulator = new ToolProcess(
            Program, "--port", "0", "--rate", "max", "--wait-for-client", "--frames", "300", "--avatars", "2", "--calculation", "--header", "old");
        string address = await ReadAddressAsync(simulator);
        using var monitor = new ToolProcess("neuron-mocap", "watch", address, "--once", "--quiet");
        string summary = await monitor.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.StartsWith(
            "{\"type\":\"summary\",\"frames\":600,\"calculationFrames\":600,\"lost\":0,\"dropped\":0,\"skippedBytes\":0,",
            summary,
            StringComparison.Ordinal);
        Assert.Equal(0, await monitor.WaitForExitAsync());
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    [Theory]
    [InlineData("binary", "header 1.1.0.0, calculation packets")]
    [InlineData("text", "text with 2 decimals, calculation lines")]
    [InlineData("studio", "as Axis Studio, header 1.1.0.1, its calculation packets")]
    public async Task Every_format_reaches_watch_and_is_named_in_the_first_line(string format, string description)
    {
        using var simulator = new ToolProcess(
            Program, "--port", "0", "--rate", "max", "--wait-for-client", "--frames", "100", "--avatars", "2", "--calculation", "--format", format);
        Assert.EndsWith(description, await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken), StringComparison.Ordinal);
        string address = await ReadAddressAsync(simulator);
        using var monitor = new ToolProcess("neuron-mocap", "watch", address, "--once", "--quiet");
        string summary = await monitor.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.StartsWith("{\"type\":\"summary\",\"frames\":200,", summary, StringComparison.Ordinal);
        Assert.Contains("\"lost\":0,\"dropped\":0,\"skippedBytes\":0,", summary, StringComparison.Ordinal);
        Assert.Equal(0, await monitor.WaitForExitAsync());
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    [Theory]
    [InlineData("binary", "header 1.1.0.0, calculation packets on a separate port")]
    [InlineData("text", "text with 2 decimals, calculation lines on a separate port")]
    [InlineData("studio", "as Axis Studio, header 1.1.0.1, its calculation packets on a separate port")]
    public async Task Calculation_has_its_own_announced_port(string format, string description)
    {
        using var simulator = new ToolProcess(
            Program, "--port", "0", "--calculation-port", "0", "--rate", "max", "--frames", "100", "--avatars", "2", "--format", format);
        Assert.EndsWith(description, await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken), StringComparison.Ordinal);
        string motion = await ReadAddressAsync(simulator);
        string? line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        Assert.StartsWith("Calculation on ", line, StringComparison.Ordinal);
        long motionBytes = await CountBytesAsync(motion);
        long calculationBytes = await CountBytesAsync(line!["Calculation on ".Length..]);
        string report = await simulator.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.StartsWith("Served 2 clients: 200 frames and 200 calculation frames sent, 0 packets dropped", report, StringComparison.Ordinal);
        if (format != "text")
            Assert.Equal((200L * 1480, format == "studio" ? 200L * 5020 : 200L * 3848), (motionBytes, calculationBytes));
        Assert.True(calculationBytes > motionBytes);
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    [Fact]
    public async Task Calculation_is_sent_alone_when_motion_is_off()
    {
        using var simulator = new ToolProcess(Program, "--port", "0", "--motion", "off", "--rate", "max", "--frames", "100");
        long bytes = await CountBytesAsync(await ReadAddressAsync(simulator));
        string report = await simulator.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.Equal(100L * 3848, bytes);
        Assert.StartsWith("Served 1 client: 0 frames and 100 calculation frames sent", report, StringComparison.Ordinal);
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    [Fact]
    public async Task A_calculation_port_in_use_ends_with_1_and_one_line_that_names_the_option()
    {
        using var other = new TcpListener(IPAddress.Loopback, 0);
        other.Start();
        await AssertFailsAsync("--calculation-port", "--port", "0", "--calculation-port", $"{((IPEndPoint)other.LocalEndpoint).Port}");
    }

    [Theory]
    [InlineData("on")]
    [InlineData("off")]
    public async Task Commands_are_answered_between_lines_unless_switched_off(string answers)
    {
        if (OperatingSystem.IsWindows())
            Assert.Skip("There are no signals to send.");

        using var simulator = new ToolProcess(
            Program, "--port", "0", "--rate", "100", "--wait-for-client", "--format", "text", "--decimals", "1", "--data-commands", answers);
        string[] address = (await ReadAddressAsync(simulator)).Split(':');
        using var client = new TcpClient(address[0], int.Parse(address[1], CultureInfo.InvariantCulture));
        byte[] requests = new byte[128];
        new DataCommandHeader { CommandId = DataCommandId.FaceDirection }.Write(requests);
        new DataCommandHeader { CommandId = DataCommandId.AvatarCount }.Write(requests.AsSpan(64));
        await client.GetStream().WriteAsync(requests, TestContext.Current.CancellationToken);
        using var reader = new StreamReader(client.GetStream(), Encoding.Latin1);
        var lines = new List<string>();
        var patience = Stopwatch.StartNew();
        while ((answers == "on" ? patience.Elapsed < Limits.Unexpected : lines.Count < 100) && (lines.Count == 0 || !IsReply(lines[^1])))
            lines.Add((await reader.ReadLineAsync(TestContext.Current.CancellationToken))!);

        Assert.Equal(answers == "on", lines.Any(IsReply));
        Assert.All(lines, line => Assert.Contains("0 Char00 -", line, StringComparison.Ordinal));
        Signals.Send("TERM", simulator.Id);
        string output = await simulator.Output.ReadToEndAsync(TestContext.Current.CancellationToken);
        Assert.Equal(answers == "on", output.Contains(", commands: 1 reply, 1 unanswered", StringComparison.Ordinal));
        Assert.Equal(0, await simulator.WaitForExitAsync());

        static bool IsReply(string line) => line.StartsWith('\u00FF');
    }

    [Fact]
    public async Task A_signal_ends_it_with_0()
    {
        if (OperatingSystem.IsWindows())
            Assert.Skip("There are no signals to send.");

        using var simulator = new ToolProcess(Program, "--port", "0");
        await ReadAddressAsync(simulator);
        Signals.Send("TERM", simulator.Id);
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    private static async Task AssertFailsAsync(string option, params string[] args)
    {
        using var simulator = new ToolProcess(Program, args);
        Assert.Equal(1, await simulator.WaitForExitAsync());
        string line = Assert.Single((await simulator.ReadErrorAsync()).Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.StartsWith($"neuron-mocap: {option}: ", line, StringComparison.Ordinal);
        AssertNamesNoMember(line);
    }

    private static async Task<string> FailAsync(string option, string path)
    {
        ToolResult result = await ToolRunner.RunAsync("simulate", "--port", "0", option, path);
        Assert.Equal(1, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.StartsWith($"neuron-mocap: {option}: ", line, StringComparison.Ordinal);
        Assert.Contains(path, line, StringComparison.Ordinal);
        return line;
    }

    // A user of the program changes options, so messages name no members.
    private static void AssertNamesNoMember(string line) => Assert.All(
        typeof(BroadcasterOptions).GetProperties().Where(property => property.Name is not ("Port" or "Format" or "Motion" or "FrameRate" or "Sources" or "Recording")),
        property => Assert.DoesNotContain(property.Name, line, StringComparison.Ordinal));

    private static async Task<long> CountBytesAsync(string address)
    {
        using var client = new TcpClient();
        await client.ConnectAsync(IPEndPoint.Parse(address), TestContext.Current.CancellationToken);
        byte[] buffer = new byte[65_536];
        long count = 0;
        int read;
        while ((read = await client.GetStream().ReadAsync(buffer, TestContext.Current.CancellationToken)) > 0)
            count += read;

        return count;
    }

    private static async Task<string> ReadAddressAsync(ToolProcess simulator)
    {
        while (true)
        {
            string? line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
            Assert.NotNull(line);
            if (line.StartsWith(Listening, StringComparison.Ordinal))
                return line[Listening.Length..];
        }
    }
}
