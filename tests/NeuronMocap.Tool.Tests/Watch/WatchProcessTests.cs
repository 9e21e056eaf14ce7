using System.Diagnostics;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Watch;

public sealed class MonitorProcessTests
{
    [Fact]
    public async Task A_closed_output_pipe_ends_the_program_quietly()
    {
        using FrameServer server = FrameServer.Repeating(FrameServer.Motion(1, new float[354]));
        using var monitor = new ToolProcess("neuron-mocap", "watch", server.Address, "--json");

        string? line = await monitor.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        monitor.Output.Close();

        Assert.StartsWith("{\"type\":", line, StringComparison.Ordinal);
        Assert.Equal(0, await monitor.WaitForExitAsync());
        Assert.Empty(await monitor.ReadErrorAsync());
    }

    [Fact]
    public async Task The_exit_codes_reach_the_shell()
    {
        using var refused = new ToolProcess("neuron-mocap", "watch", FrameServer.RefusingAddress(), "--once", "--quiet");
        using var wrong = new ToolProcess("neuron-mocap", "watch", "--frames", "none");

        Assert.Equal(1, await refused.WaitForExitAsync());
        Assert.Single((await refused.ReadErrorAsync()).Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.Equal(2, await wrong.WaitForExitAsync());
    }

    [Fact]
    public async Task The_version_is_three_numbers()
    {
        using var program = new ToolProcess("neuron-mocap", "--version");
        string version = await program.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.Matches("^[0-9]+\\.[0-9]+\\.[0-9]+\\s*$", version);
        Assert.Equal(0, await program.WaitForExitAsync());
    }

    [Theory]
    [InlineData("INT")]
    [InlineData("TERM")]
    public async Task A_signal_ends_with_the_summary_and_0(string signal)
    {
        if (OperatingSystem.IsWindows())
            Assert.Skip("There are no signals to send.");
        if (signal is "INT" && ToolProcess.IgnoresInterrupt())
            Assert.Skip("The shell that runs the tests in the background has switched SIGINT off, and programs inherit that.");

        using FrameServer server = FrameServer.Sending(FrameServer.Motion(1, 1), FrameServer.Motion(2, 2));
        using var monitor = new ToolProcess("neuron-mocap", "watch", server.Address, "--json");
        string? line;
        do
            line = await monitor.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        while (line?.Contains("\"index\":2", StringComparison.Ordinal) == false);

        Signals.Send(signal, monitor.Id);
        Task<string> reading = monitor.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.Equal(0, await monitor.WaitForExitAsync());
        string rest = await reading;
        Assert.StartsWith("{\"type\":\"summary\",\"frames\":", rest.Split('\n', StringSplitOptions.RemoveEmptyEntries)[^1], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("neuron-mocap watch", "--frames", "20", "--json")]
    [InlineData("neuron-mocap watch", "--frames", "20", "--quiet")]
    [InlineData("neuron-mocap simulate", "--port", "0", "--frames", "1")]
    public async Task A_full_disk_is_one_line_of_error(string program, params string[] args)
    {
        if (!File.Exists("/dev/full"))
            Assert.Skip("This system has no device that is always full.");

        string command = $"exec dotnet {ToolProcess.PathOf("neuron-mocap")} {program["neuron-mocap".Length..]} {string.Join(' ', args)} > /dev/full";
        using Process shell = Process.Start(new ProcessStartInfo("sh", ["-c", command]) { RedirectStandardError = true, UseShellExecute = false })!;
        string error = await shell.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        await shell.WaitForExitAsync(TestContext.Current.CancellationToken);

        Assert.Equal(1, shell.ExitCode);
        Assert.Contains("standard output", Assert.Single(error.Split('\n', StringSplitOptions.RemoveEmptyEntries)), StringComparison.Ordinal);
    }
}
