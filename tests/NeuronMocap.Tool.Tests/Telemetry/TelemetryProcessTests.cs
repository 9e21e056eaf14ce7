using System.Text;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Telemetry;

public sealed class TelemetryProcessTests
{
    [Fact]
    public async Task Frames_of_the_demo_reach_the_collector()
    {
        await using OtlpReceiver collector = await OtlpReceiver.StartAsync();
        using var program = new ToolProcess("neuron-telemetry", "--demo", "--otlp", collector.Url, "--interval", "0.2", "--duration", "3");
        Task<string> error = program.ReadErrorAsync();
        string output = await program.Output.ReadToEndAsync();
        int exitCode = await program.WaitForExitAsync();
        Assert.True(exitCode == 0, output + await error);

        OtlpMetric[] frames = [.. collector.Metrics.Where(metric => metric.Name == "neuron.reader.frames" && metric.Tags.Contains("neuron.frame.kind=motion"))];
        Assert.All(frames, metric => Assert.Equal("{frame}", metric.Unit));
        Assert.All(frames, metric => Assert.Contains("neuron.reader.name=stage", metric.Tags));
        Assert.Equal(frames.Select(metric => metric.Value).Order(), frames.Select(metric => metric.Value));

        // 60 Hz for at most 3 s, and a little for the start of a process on a busy machine.
        Assert.InRange(frames[^1].Value, 2, 400);
        Assert.Equal(0, collector.Metrics.Last(metric => metric.Name == "neuron.reader.lost").Value);
        Assert.InRange(collector.Metrics.Last(metric => metric.Name == "neuron.reader.frame.interval").Value, 1, 400);
        Assert.Contains(collector.Metrics, metric =>
            metric is { Name: "neuron.reader.state", Value: 1 } && metric.Tags.Contains("neuron.connection.state=receiving"));
        Assert.Contains("Receiving from", string.Concat(collector.Logs.Select(Encoding.UTF8.GetString)), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Without_a_collector_it_says_so()
    {
        using var program = new ToolProcess("neuron-telemetry", "--demo", "--otlp", "http://" + FrameServer.RefusingAddress(), "--duration", "1");
        Task<string> output = program.Output.ReadToEndAsync();
        string error = await program.ReadErrorAsync();
        await output;
        Assert.Equal(1, await program.WaitForExitAsync());
        Assert.Contains("took nothing", error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("Port is 0; it must be 1 to 65535.", "--host", "studio", "--port", "0")]
    [InlineData("Port is 'x'; it must be a whole number.", "--port", "x")]
    [InlineData("--demo is a server of its own", "--demo", "--host", "studio")]
    [InlineData("--otlp ftp://x is not the address of a collector", "--otlp", "ftp://x")]
    [InlineData("--duration soon is not a number of seconds", "--duration", "soon")]
    public async Task Wrong_options_are_named(string expected, params string[] args)
    {
        using var program = new ToolProcess("neuron-telemetry", args);
        Task<string> output = program.Output.ReadToEndAsync();
        string error = await program.ReadErrorAsync();
        await output;
        Assert.Equal(2, await program.WaitForExitAsync());
        Assert.Contains(expected, error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Help_lists_options_and_exit_codes()
    {
        using var program = new ToolProcess("neuron-telemetry", "--help");
        string output = await program.Output.ReadToEndAsync();
        Assert.Equal(0, await program.WaitForExitAsync());
        foreach (string part in (string[])["--host", "--otlp", "--interval", "Exit codes", "NeuronReader__"])
            Assert.Contains(part, output, StringComparison.Ordinal);
    }
}
