using System.Text;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Hosting.Tests.Samples;

// The program runs until a test has seen enough: how long that takes depends on how busy the computer is.
public sealed class TelemetryProcessTests
{
    private const string NoSignals = "There are no signals to send.";
    private const string Receiving = "neuron.connection.state=receiving";

    [Fact]
    public async Task Frames_logs_and_connections_reach_the_collector()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), NoSignals);
        await using OtlpReceiver collector = await OtlpReceiver.StartAsync();
        using (var program = new ToolProcess("Telemetry", $"--Collector={collector.Url}", "--OTEL_METRIC_EXPORT_INTERVAL=200"))
        {
            Task<string> output = program.Output.ReadToEndAsync();
            Task<string> error = program.ReadErrorAsync();
            try
            {
                await Limits.UntilAsync(() => output.IsCompleted || (FramesOf(collector).Any(static metric => metric.Value >= 2) && StatesOf(collector).Contains(Receiving)));
            }
            catch (OperationCanceledException)
            {
                program.Kill();
                await output;
            }

            Assert.False(output.IsCompleted, output.IsCompleted ? await output + await error : null);
            Signals.Send("TERM", program.Id);
            Assert.Equal((0, string.Empty), (await program.WaitForExitAsync(), await error));
        }

        OtlpMetric[] frames = [.. FramesOf(collector)];
        Assert.All(frames, metric => Assert.Equal("{frame}", metric.Unit));
        Assert.All(frames, metric => Assert.Contains("neuron.reader.name=stage", metric.Tags));
        Assert.Equal(frames.Select(metric => metric.Value).Order(), frames.Select(metric => metric.Value));
        Assert.Equal(0, collector.Metrics.Last(metric => metric.Name == "neuron.reader.lost").Value);
        Assert.InRange(collector.Metrics.Last(metric => metric.Name == "neuron.reader.frame.interval").Value, 1, frames[^1].Value);

        // The last export comes from a stopped reader.
        Assert.Contains("neuron.connection.state=stopped", StatesOf(collector));
        Assert.Contains("Receiving from", Text(collector.Logs), StringComparison.Ordinal);
        Assert.Contains("Receiving from", Text(collector.Traces), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_missing_collector_is_reported()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), NoSignals);
        string nobody;
        await using (OtlpReceiver collector = await OtlpReceiver.StartAsync())
            nobody = collector.Url;

        using var program = new ToolProcess("Telemetry", $"--Collector={nobody}");
        Task<string> error = program.ReadErrorAsync();
        string? line;
        do
            line = await program.Output.ReadLineAsync(TestContext.Current.CancellationToken).AsTask().Soon();
        while (line?.Contains("Receiving from", StringComparison.Ordinal) == false);
        Assert.True(line is not null, line is null ? await error : null);
        Task<string> rest = program.Output.ReadToEndAsync();
        Signals.Send("TERM", program.Id);
        Assert.Equal(1, await program.WaitForExitAsync());
        await rest;
        Assert.Contains("took nothing", await error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_program_ends_after_its_seconds()
    {
        using var program = new ToolProcess("Telemetry", "--NeuronReader:Host=127.0.0.1", $"--NeuronReader:Port={FreePort.Next()}", "--Seconds=1");
        Task<string> output = program.Output.ReadToEndAsync();
        string error = await program.ReadErrorAsync();
        await output;
        Assert.Equal(1, await program.WaitForExitAsync());
        Assert.Contains("No frame arrived", error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("Port is 0; it must be 1 to 65535.", "--NeuronReader:Host=studio", "--NeuronReader:Port=0")]
    [InlineData("Port is 'x'; it must be a whole number.", "--NeuronReader:Port=x")]
    [InlineData("Collector is 'studio'; it must be an address", "--Collector=studio")]
    [InlineData("Seconds is 'abc'; it must be a number of seconds.", "--Seconds=abc")]
    [InlineData("Seconds is '-1'; it must be a number of seconds.", "--Seconds=-1")]
    public async Task Wrong_settings_are_named(string expected, params string[] args)
    {
        using var program = new ToolProcess("Telemetry", args);
        Task<string> output = program.Output.ReadToEndAsync();
        string error = await program.ReadErrorAsync();
        await output;
        Assert.Equal(2, await program.WaitForExitAsync());
        Assert.Contains(expected, error, StringComparison.Ordinal);
    }

    private static IEnumerable<OtlpMetric> FramesOf(OtlpReceiver collector) =>
        collector.Metrics.Where(static metric => metric.Name == "neuron.reader.frames" && metric.Tags.Contains("neuron.frame.kind=motion"));

    private static IEnumerable<string> StatesOf(OtlpReceiver collector) =>
        collector.Metrics.Where(static metric => metric is { Name: "neuron.reader.state", Value: 1 }).SelectMany(static metric => metric.Tags);

    private static string Text(IEnumerable<byte[]> requests) => string.Concat(requests.Select(Encoding.UTF8.GetString));
}
