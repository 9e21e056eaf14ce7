using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Diagnose;

public sealed class DiagnosisTests
{
    [Fact]
    public async Task A_healthy_stream_shows_its_steps_and_code_and_ends_with_0()
    {
        ToolResult result = await ToolRunner.RunAsync("diagnose", "demo", "--duration", "15");

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);
        Assert.Equal(
            ["name", "route", "port", "first bytes", "token", "version", "format"],
            result.Output.Where(static line => line.StartsWith("ok\t", StringComparison.Ordinal)).Take(7).Select(static line => line[3..15].TrimEnd()));
        Assert.Contains(result.Output, static line => line.StartsWith("FRAMES ARRIVE", StringComparison.Ordinal));
        Assert.Contains(result.Output, static line => line.Contains("1 avatar: 0 Demo", StringComparison.Ordinal));
        Assert.Contains(result.Output, static line => line.Contains("new NeuronReader(\"127.0.0.1\", ", StringComparison.Ordinal));
        Assert.DoesNotContain(result.Output, static line => line.Contains('\e', StringComparison.Ordinal));
    }

    // A serial line or a plain pseudo-terminal reports 0.
    [Theory]
    [InlineData(0)]
    [InlineData(7)]
    public async Task A_terminal_of_unknown_size_is_treated_as_narrow(int columns)
    {
        ToolResult result = await ToolRunner.RunOnTerminalAsync(columns, "diagnose", "demo", "--duration", "15");

        Assert.Equal(0, result.ExitCode);
        Assert.StartsWith("Looking for frames from 127.0.0.1:", result.Output[0], StringComparison.Ordinal);
    }

    // Other programs on this machine may stream on the usual ports and would be found. Tests of the library check the message for that case.
    [Fact]
    public async Task A_fault_is_one_paragraph_and_ends_with_1()
    {
        ToolResult result = await ToolRunner.RunAsync("diagnose", FrameServer.RefusingAddress(), "--duration", "2");

        Assert.Equal(1, result.ExitCode);
        Assert.Empty(result.Error);
        Assert.Contains(result.Output, static line => line.StartsWith("FAIL\tport", StringComparison.Ordinal));
        Assert.True(Array.FindIndex(result.Output, static line => line.All(static letter => !char.IsLower(letter))) > 0, "There is no title.");
    }

    [Fact]
    public async Task The_server_may_be_named_by_connect()
    {
        string address = FrameServer.RefusingAddress();
        ToolResult result = await ToolRunner.RunAsync("diagnose", address, "--duration", "2");

        Assert.Equal(1, result.ExitCode);
        Assert.Equal($"Looking for frames from {address} over TCP.", result.Output[0]);
    }

    [Fact]
    public async Task A_UDP_port_in_use_is_reported()
    {
        using var probe = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        probe.Bind(new IPEndPoint(IPAddress.Any, 0));
        string port = $"{((IPEndPoint)probe.LocalEndPoint!).Port}";
        ToolResult result = await ToolRunner.RunAsync("diagnose", $"udp://:{port}", "--duration", "15");

        Assert.Equal(1, result.ExitCode);
        Assert.Contains($"UDP port {port}", result.Output[0], StringComparison.Ordinal);
        Assert.Contains("PORT IN USE", result.Output);
    }

    [Theory]
    [InlineData("--json")]
    [InlineData("--quiet")]
    public async Task Json_is_one_object_per_line(string output)
    {
        using FrameServer server = FrameServer.Sending("SSH-2.0-Test\r\n"u8.ToArray());
        ToolResult result = await ToolRunner.RunAsync("diagnose", server.Address, "--duration", "15", output);

        Assert.Equal(1, result.ExitCode);
        Assert.Equal(output is "--json", result.OfType("step").Length > 0);
        using JsonDocument diagnosis = JsonDocument.Parse(result.Output[^1]);
        Assert.Equal("diagnosis", diagnosis.RootElement.GetProperty("type").GetString());
        Assert.Equal("OtherProgram", diagnosis.RootElement.GetProperty("verdict").GetString());
        Assert.False(diagnosis.RootElement.GetProperty("framesArrive").GetBoolean());
        Assert.Contains("SSH-2.0-Test", diagnosis.RootElement.GetProperty("summary").GetString(), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Avatars_are_part_of_the_object()
    {
        using FrameServer server = FrameServer.Repeating(FrameServer.Motion(1, new float[354]));
        ToolResult result = await ToolRunner.RunAsync("diagnose", server.Address, "--duration", "15", "--quiet");

        Assert.Equal(0, result.ExitCode);
        using JsonDocument diagnosis = JsonDocument.Parse(Assert.Single(result.Output));
        JsonElement avatar = Assert.Single(diagnosis.RootElement.GetProperty("avatars").EnumerateArray());
        Assert.Equal("Char00", avatar.GetProperty("name").GetString());
        Assert.Equal("Motionless", diagnosis.RootElement.GetProperty("verdict").GetString());
    }

    [Theory]
    [InlineData("--frames", "diagnose", "studio", "--frames", "5")]
    [InlineData("--once", "diagnose", "studio", "--once")]
    [InlineData("'other'", "diagnose", "studio", "other")]
    [InlineData("--server", "diagnose", "studio", "--server", "other")]
    [InlineData("--quiet", "diagnose", "studio", "--json", "--quiet")]
    [InlineData("info take.nmrec", "diagnose", "take.nmrec")]
    [InlineData("--duration", "diagnose", "studio", "--duration", "0.5")]
    [InlineData("'port'", "diagnose", "studio:port")]
    public async Task Options_of_other_verbs_are_refused(string named, params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync(args);

        Assert.Equal(2, result.ExitCode);
        Assert.Contains(named, result.Error[0], StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_signal_ends_it_with_130()
    {
        if (OperatingSystem.IsWindows())
            Assert.Skip("There are no signals to send.");

        using FrameServer server = FrameServer.Silent();
        using var monitor = new ToolProcess("neuron-mocap", "diagnose", server.Address, "--duration", "300", "--json");
        string? line;
        do
            line = await monitor.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        while (line?.Contains("\"name\":\"port\"", StringComparison.Ordinal) == false);

        Signals.Send("TERM", monitor.Id);
        Assert.Equal(130, await monitor.WaitForExitAsync());
        Assert.Empty(await monitor.ReadErrorAsync());
    }
}
