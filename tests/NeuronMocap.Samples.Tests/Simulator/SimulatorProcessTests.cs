using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Samples.Tests.Infrastructure;

namespace NeuronMocap.Samples.Tests.Simulator;

public sealed class SimulatorProcessTests
{
    private const string Program = "neuron-simulator";
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
    [InlineData("--commands", "65536")]
    [InlineData("--commands", "7001")]
    [InlineData("--commands", "--port", "8013")]
    [InlineData("--unknown")]
    public async Task Bad_usage_ends_with_2_and_the_usage_line(params string[] args)
    {
        using var simulator = new SampleProcess(Program, args);
        Assert.Equal(2, await simulator.WaitForExitAsync());
        Assert.Contains("neuron-simulator [", await simulator.ReadErrorAsync(), StringComparison.Ordinal);
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
        await AssertFailsAsync("--commands", "--port", "0", "--commands", $"{((IPEndPoint)other.LocalEndpoint).Port}");
    }

    [Fact]
    public async Task The_command_channel_says_where_it_is_and_answers_the_monitor()
    {
        using var simulator = new SampleProcess(Program, "--port", "0", "--commands", "0", "--order", "XZY");
        await ReadAddressAsync(simulator);
        string? line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        Assert.StartsWith("Commands on ", line, StringComparison.Ordinal);
        using var monitor = new SampleProcess("neuron-monitor", "--commands", line!["Commands on ".Length..], "--json");
        string answer = await monitor.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.Contains("\"rotationOrder\":\"XZY\"", answer, StringComparison.Ordinal);
        Assert.Equal(0, await monitor.WaitForExitAsync());
    }

    [Fact]
    public async Task A_file_that_is_not_there_ends_with_1_and_one_line_that_names_the_option() =>
        await AssertFailsAsync("--bvh", "--bvh", Path.Combine(Path.GetTempPath(), Path.GetRandomFileName()));

    [Fact]
    public async Task A_file_that_is_no_take_ends_with_1_and_one_line_that_names_the_option() =>
        await AssertFailsAsync("--bvh", "--bvh", typeof(SimulatorProcessTests).Assembly.Location);

    [Fact]
    public async Task Frames_of_all_avatars_reach_the_monitor_and_both_programs_end()
    {
        using var simulator = new SampleProcess(
            Program, "--port", "0", "--rate", "max", "--wait-for-client", "--frames", "300", "--avatars", "2", "--calculation", "--header", "old");
        string address = await ReadAddressAsync(simulator);
        using var monitor = new SampleProcess("neuron-monitor", "--connect", address, "--once", "--quiet");
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
    public async Task Every_format_reaches_the_monitor_and_the_first_line_names_it(string format, string description)
    {
        using var simulator = new SampleProcess(
            Program, "--port", "0", "--rate", "max", "--wait-for-client", "--frames", "100", "--avatars", "2", "--calculation", "--format", format);
        Assert.EndsWith(description, await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken), StringComparison.Ordinal);
        string address = await ReadAddressAsync(simulator);
        using var monitor = new SampleProcess("neuron-monitor", "--connect", address, "--once", "--quiet");
        string summary = await monitor.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.StartsWith("{\"type\":\"summary\",\"frames\":200,", summary, StringComparison.Ordinal);
        Assert.Contains("\"lost\":0,\"dropped\":0,\"skippedBytes\":0,", summary, StringComparison.Ordinal);
        Assert.Equal(0, await monitor.WaitForExitAsync());
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    [Theory]
    [InlineData("on")]
    [InlineData("off")]
    public async Task Commands_are_answered_between_lines_unless_told_not_to(string answers)
    {
        if (OperatingSystem.IsWindows())
            Assert.Skip("There are no signals to send.");

        using var simulator = new SampleProcess(
            Program, "--port", "0", "--rate", "100", "--wait-for-client", "--format", "text", "--decimals", "1", "--data-commands", answers);
        string[] address = (await ReadAddressAsync(simulator)).Split(':');
        using var client = new TcpClient(address[0], int.Parse(address[1], CultureInfo.InvariantCulture));
        byte[] requests = new byte[128];
        new CommandHeader { CommandId = DataCommandId.FaceDirection }.Write(requests);
        new CommandHeader { CommandId = DataCommandId.AvatarCount }.Write(requests.AsSpan(64));
        await client.GetStream().WriteAsync(requests, TestContext.Current.CancellationToken);
        using var reader = new StreamReader(client.GetStream(), Encoding.Latin1);
        var lines = new List<string>();
        while (lines.Count < 100 && !lines.Any(IsReply))
            lines.Add((await reader.ReadLineAsync(TestContext.Current.CancellationToken))!);

        Assert.Equal(answers == "on", lines.Any(IsReply));
        Assert.All(lines, line => Assert.Contains("0 Char00 -", line, StringComparison.Ordinal));
        using Process kill = Process.Start("kill", ["-TERM", $"{simulator.Id}"]);
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

        using var simulator = new SampleProcess(Program, "--port", "0");
        await ReadAddressAsync(simulator);
        using Process kill = Process.Start("kill", ["-TERM", $"{simulator.Id}"]);
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    private static async Task AssertFailsAsync(string option, params string[] args)
    {
        using var simulator = new SampleProcess(Program, args);
        Assert.Equal(1, await simulator.WaitForExitAsync());
        string line = Assert.Single((await simulator.ReadErrorAsync()).Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.Contains(option, line, StringComparison.Ordinal);
    }

    private static async Task<string> ReadAddressAsync(SampleProcess simulator)
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
