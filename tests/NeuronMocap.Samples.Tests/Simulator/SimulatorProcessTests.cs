using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
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
    [InlineData("--commands", "65536")]
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
