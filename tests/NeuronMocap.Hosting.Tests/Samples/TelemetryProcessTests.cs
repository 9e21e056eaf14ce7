using System.Text;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Hosting.Tests.Samples;

public sealed class TelemetryProcessTests
{
    [Fact]
    public async Task Frames_logs_and_connections_reach_the_collector()
    {
        // On a busy computer, three seconds can be too short for the first frame, or for an export while frames arrive.
        await using OtlpReceiver quick = await OtlpReceiver.StartAsync();
        bool isEnough = await RunAsync(quick, seconds: 3) && States(quick).Contains("neuron.connection.state=receiving");
        await using OtlpReceiver slow = await OtlpReceiver.StartAsync();
        OtlpReceiver collector = isEnough ? quick : slow;
        Assert.True(isEnough || await RunAsync(slow, seconds: 60));

        OtlpMetric[] frames = [.. collector.Metrics.Where(metric => metric.Name == "neuron.reader.frames" && metric.Tags.Contains("neuron.frame.kind=motion"))];
        Assert.All(frames, metric => Assert.Equal("{frame}", metric.Unit));
        Assert.All(frames, metric => Assert.Contains("neuron.reader.name=stage", metric.Tags));
        Assert.Equal(frames.Select(metric => metric.Value).Order(), frames.Select(metric => metric.Value));

        Assert.True(frames[^1].Value >= 2);
        Assert.Equal(0, collector.Metrics.Last(metric => metric.Name == "neuron.reader.lost").Value);
        Assert.InRange(collector.Metrics.Last(metric => metric.Name == "neuron.reader.frame.interval").Value, 1, frames[^1].Value);
        string[] states = States(collector);
        Assert.Contains("neuron.connection.state=receiving", states);

        // The last export comes from a stopped reader.
        Assert.Contains("neuron.connection.state=stopped", states);
        Assert.Contains("Receiving from", Text(collector.Logs), StringComparison.Ordinal);
        Assert.Contains("Receiving from", Text(collector.Traces), StringComparison.Ordinal);

        static string[] States(OtlpReceiver collector) =>
            [.. collector.Metrics.Where(metric => metric is { Name: "neuron.reader.state", Value: 1 }).SelectMany(metric => metric.Tags)];

        static async Task<bool> RunAsync(OtlpReceiver collector, int seconds)
        {
            using var program = new ToolProcess("Telemetry", $"--Collector={collector.Url}", "--OTEL_METRIC_EXPORT_INTERVAL=200", $"--Seconds={seconds}");
            Task<string> error = program.ReadErrorAsync();
            string output = await program.Output.ReadToEndAsync();
            int exitCode = await program.WaitForExitAsync();
            Assert.True(exitCode == 0 || (await error).Contains("No frame arrived", StringComparison.Ordinal), output + await error);
            return exitCode == 0;
        }
    }

    [Fact]
    public async Task A_missing_collector_is_reported()
    {
        string nobody;
        await using (OtlpReceiver collector = await OtlpReceiver.StartAsync())
            nobody = collector.Url;

        string error = await RunAsync(seconds: 1);

        // On a busy computer, a second can be too short for the first frame.
        if (error.Contains("No frame arrived", StringComparison.Ordinal))
            error = await RunAsync(seconds: 30);

        Assert.Contains("took nothing", error, StringComparison.Ordinal);

        async Task<string> RunAsync(int seconds)
        {
            using var program = new ToolProcess("Telemetry", $"--Collector={nobody}", $"--Seconds={seconds}");
            Task<string> output = program.Output.ReadToEndAsync();
            string errors = await program.ReadErrorAsync();
            await output;
            Assert.Equal(1, await program.WaitForExitAsync());
            return errors;
        }
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

    private static string Text(IEnumerable<byte[]> requests) => string.Concat(requests.Select(Encoding.UTF8.GetString));
}
