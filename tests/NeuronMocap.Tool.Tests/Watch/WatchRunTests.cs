using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Text.Json;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Watch;

public sealed class WatchRunTests
{
    [Fact]
    public async Task Json_prints_every_frame_in_order_and_a_summary_last()
    {
        using FrameServer server = FrameServer.Sending(
            FrameServer.Motion(7, 1.5f, -0f), FrameServer.Calculation(7, 2), "noise"u8.ToArray(), FrameServer.Motion(9, 3, 4));

        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--once", "--json");

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);
        Assert.Equal(
            [
                """{"type":"start","program":"neuron-mocap",""",
                """{"type":"skeleton","avatar":0,"name":"Char00","index":7,"sender":0,""",
                """{"type":"frame","avatar":0,"name":"Char00","index":7,"displacement":true,"reference":false,"sender":0,""",
                """{"type":"calculation","avatar":0,"name":"Char00","index":7,"sender":0,""",
                """{"type":"frame","avatar":0,"name":"Char00","index":9,"displacement":true,"reference":false,"sender":0,""",
            ],
            result.Output
                .Where(line => !line.Contains("\"status\"", StringComparison.Ordinal) && !line.Contains("\"summary\"", StringComparison.Ordinal))
                .Select(line => line[..(line.IndexOf(line.Contains("\"sender\"", StringComparison.Ordinal) ? "\"time\"" : "\"version\"", StringComparison.Ordinal))]),
            StringComparer.Ordinal);
        Assert.Equal(
            ["[1.5,-0.0]}", "[2]}", "[3,4]}"],
            result.Output.Where(line => line.Contains("\"values\":", StringComparison.Ordinal)).Select(line => line.Split("\"values\":")[1]));
        Assert.StartsWith(
            """{"type":"summary","frames":2,"calculationFrames":1,"lost":1,"dropped":0,"skippedBytes":5,"seconds":""",
            result.Output[^1],
            StringComparison.Ordinal);
        Assert.Contains(result.OfType("status"), line => line.Contains("\"state\":\"Receiving\"", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(101)]
    public async Task The_frame_limit_is_exact(int frames)
    {
        using FrameServer server = FrameServer.Repeating([.. FrameServer.Motion(1, 1), .. FrameServer.Calculation(1, 2)]);

        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--json", "--frames", $"{frames}");

        Assert.Equal(0, result.ExitCode);
        Assert.Equal((frames + 1) / 2, result.OfType("frame").Length);
        Assert.Equal(frames / 2, result.OfType("calculation").Length);
        Assert.StartsWith(
            $$"""{"type":"summary","frames":{{(frames + 1) / 2}},"calculationFrames":{{frames / 2}},""", result.Output[^1], StringComparison.Ordinal);
    }

    [Fact]
    public async Task Slow_output_loses_no_frame()
    {
        float[] values = new float[354];
        using FrameServer server = FrameServer.Sending([.. Enumerable.Range(0, 3000).Select(index => FrameServer.Motion((uint)index, values))]);
        using var output = new SlowStream();

        ToolResult result = await ToolRunner.RunAsync(output, ["watch", server.Address, "--once", "--json"]);

        Assert.Equal(0, result.ExitCode);
        Assert.Equal(Enumerable.Range(0, 3000), output.FrameIndices);
    }

    [Fact]
    public async Task Quiet_prints_only_the_summary()
    {
        using FrameServer server = FrameServer.Sending(FrameServer.Motion(1, 1), FrameServer.Motion(2, 1));

        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--once", "--quiet");

        Assert.Equal(0, result.ExitCode);
        Assert.StartsWith("""{"type":"summary","frames":2,"calculationFrames":0,"lost":0,"dropped":0,"skippedBytes":0,"seconds":""", Assert.Single(result.Output), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--quiet")]
    [InlineData("--once")]
    public async Task A_silent_calculation_port_is_reported_while_motion_arrives(string output)
    {
        using FrameServer server = FrameServer.Pacing(static number => FrameServer.Motion((uint)number, 1));

        // Bound but not listening: it refuses connections, and no other program gets the port.
        using var refusing = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        refusing.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        int port = ((IPEndPoint)refusing.LocalEndPoint!).Port;
        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--calculation-port", $"{port}", "--duration", "6", output);

        Assert.Equal(0, result.ExitCode);
        Assert.Contains("calculation", Assert.Single(result.Error), StringComparison.OrdinalIgnoreCase);
        if (output != "--quiet")
            Assert.Contains(result.Output, static line => line.Contains(" Receiving: ", StringComparison.Ordinal) && line.Contains("refused", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_quiet_summary_has_the_time_of_the_run()
    {
        using FrameServer server = FrameServer.Pacing(static number => FrameServer.Motion((uint)number, 1));
        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--frames", "5000", "--quiet");
        using var summary = JsonDocument.Parse(Assert.Single(result.Output));
        double frames = summary.RootElement.GetProperty("seconds").GetDouble();
        Assert.InRange(frames, 1e-6, summary.RootElement.GetProperty("time").GetDouble());
    }

    [Theory]
    [InlineData("--json")]
    [InlineData("--quiet")]
    public async Task A_refused_connection_ends_a_single_attempt_with_1_and_one_line(string output)
    {
        ToolResult result = await ToolRunner.RunAsync("watch", FrameServer.RefusingAddress(), "--once", output);

        Assert.Equal(1, result.ExitCode);
        Assert.Contains("refused", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.StartsWith("""{"type":"summary","frames":0,""", result.Output[^1], StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_refused_connection_is_retried_for_the_duration()
    {
        ToolResult result = await ToolRunner.RunAsync("watch", FrameServer.RefusingAddress(), "--duration", "3", "--json");

        Assert.Equal(1, result.ExitCode);
        Assert.Contains("refused", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Contains(result.OfType("status"), line => line.Contains("\"Waiting\"", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_silent_server_ends_with_1_and_the_setting()
    {
        using FrameServer server = FrameServer.Silent();

        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--duration", "4", "--quiet");

        Assert.Equal(1, result.ExitCode);
        Assert.Contains("broadcasting", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Unknown_bytes_end_with_1_and_the_format()
    {
        using FrameServer server = FrameServer.Sending(Encoding.ASCII.GetBytes("0 Char00 0.00 93.02 ||\r\n"));

        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--once", "--quiet");

        Assert.Equal(1, result.ExitCode);
        Assert.Contains("Binary", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_UDP_port_in_use_is_named()
    {
        using var other = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        other.Bind(new IPEndPoint(IPAddress.Any, 0));
        int port = ((IPEndPoint)other.LocalEndPoint!).Port;

        ToolResult result = await ToolRunner.RunAsync("watch", $"udp://:{port}", "--once", "--quiet");

        Assert.Equal(1, result.ExitCode);
        Assert.Contains($"UDP port {port} is in use by another program", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("127.0.0.1", 0)]
    [InlineData("192.0.2.1", 1)]
    public async Task Over_udp_only_an_allowed_sender_is_received(string allowed, int exitCode)
    {
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        int port = FreePort.Next();
        ToolResult result = await RunAsync(exitCode == 0 ? "60" : "4");

        // The program tells what it refuses after three seconds of silence. A busy computer takes longer.
        if (exitCode != 0 && !result.Error.Any(static line => line.Contains("--allow-sender", StringComparison.Ordinal)))
            result = await RunAsync("30");

        Assert.Equal(exitCode, result.ExitCode);
        if (exitCode != 0)
        {
            Assert.Contains("127.0.0.1", Assert.Single(result.Error), StringComparison.Ordinal);
            Assert.Contains("--allow-sender", Assert.Single(result.Error), StringComparison.Ordinal);
        }

        async Task<ToolResult> RunAsync(string duration)
        {
            Task<ToolResult> running = ToolRunner.RunAsync("watch", $"udp://:{port}", "--allow-sender", allowed, "--allow-sender", "192.0.2.2", "--frames", "3", "--duration", duration, "--quiet");
            for (int i = 0; !running.IsCompleted; i++)
            {
                sender.SendTo(FrameServer.Motion((uint)i, 1), new IPEndPoint(IPAddress.Loopback, port));
                await Task.WhenAny(running, Task.Delay(5, TestContext.Current.CancellationToken));
            }

            return await running;
        }
    }

    [Fact]
    public async Task Redirected_output_is_plain_lines()
    {
        using FrameServer server = FrameServer.Sending(FrameServer.Motion(1, 1));

        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--once");

        Assert.Equal(0, result.ExitCode);
        Assert.StartsWith("1 motion and 0 calculation frames", result.Output[^1], StringComparison.Ordinal);
        Assert.DoesNotContain('\e', string.Concat(result.Output));
    }

    [Fact]
    public async Task The_demo_sends_what_the_simulator_sends_by_default()
    {
        ToolResult result = await ToolRunner.RunAsync("watch", "--frames", "4", "--json");

        Assert.Equal(0, result.ExitCode);
        Assert.Equal(4, result.OfType("frame").Length);
        Assert.Empty(result.OfType("calculation"));
        Assert.Contains("\"index\":0,\"displacement\":true", result.OfType("frame")[0], StringComparison.Ordinal);
    }

    // Takes every line, one at a time and slowly.
    private sealed class SlowStream : MemoryStream
    {
        public List<int> FrameIndices { get; } = [];

        public override void Write(ReadOnlySpan<byte> buffer)
        {
            Thread.Yield();
            string line = Encoding.UTF8.GetString(buffer);
            if (line.StartsWith("{\"type\":\"frame\"", StringComparison.Ordinal))
                FrameIndices.Add(int.Parse(line.Split("\"index\":")[1].Split(',')[0], provider: null));
        }
    }
}
