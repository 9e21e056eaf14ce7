using NeuronMocap.Samples.Tests.Infrastructure;

namespace NeuronMocap.Samples.Tests.Monitor;

public sealed class CommandLineTests
{
    [Theory]
    [InlineData("--frames", "--frames", "0")]
    [InlineData("--frames", "--frames", "-1")]
    [InlineData("--frames", "--frames", "1.5")]
    [InlineData("--frames", "--frames")]
    [InlineData("--duration", "--duration", "0")]
    [InlineData("--duration", "--duration", "NaN")]
    [InlineData("--duration", "--duration", "1,5")]
    [InlineData("--duration", "--duration", "1000001")]
    [InlineData("--udp", "--udp", "0")]
    [InlineData("--udp", "--udp", "65536")]
    [InlineData("--order", "--order", "XXY")]
    [InlineData("--order", "--order", "1")]
    [InlineData("--connect", "--connect", "studio:port")]
    [InlineData("--udp", "--connect", "studio", "--udp", "7001")]
    [InlineData("--demo", "--connect", "studio", "--demo")]
    [InlineData("--quiet", "--json", "--quiet")]
    [InlineData("--allow-sender", "--udp", "7001", "--allow-sender", "studio")]
    [InlineData("--allow-sender", "--udp", "7001", "--allow-sender")]
    [InlineData("--udp", "--connect", "studio", "--allow-sender", "127.0.0.1")]
    [InlineData("--udp", "--allow-sender", "127.0.0.1")]
    [InlineData("--command-port", "--connect", "studio", "--command-port", "0")]
    [InlineData("--connect", "--command-port", "8013")]
    [InlineData("--connect", "--udp", "7001", "--command-port", "8013")]
    [InlineData("--commands", "--commands", "studio:port")]
    [InlineData("--commands", "--avatar", "1")]
    [InlineData("--commands", "--zero-out", "all")]
    [InlineData("--commands", "--bvh-header")]
    [InlineData("--avatar", "--commands", "--avatar", "-1")]
    [InlineData("--zero-out", "--commands", "--zero-out", "some")]
    [InlineData("--zero-out", "--commands", "--zero-out", "1", "--avatar", "1")]
    [InlineData("--json", "--commands", "--bvh-header", "--json")]
    [InlineData("--connect", "--commands", "--connect", "studio")]
    [InlineData("--diagnose", "--commands", "--diagnose")]
    [InlineData("--quiet", "--commands", "--quiet")]
    [InlineData("--record", "--record")]
    [InlineData("--record", "--record", " ")]
    [InlineData("--record", "--record-compress")]
    [InlineData("--record-size", "--record", "take", "--record-size", "1")]
    [InlineData("--record-time", "--record", "take", "--record-time", "0")]
    [InlineData("--record-files", "--record", "take", "--record-files", "3")]
    [InlineData("--diagnose", "--record", "take", "--diagnose")]
    [InlineData("--commands", "--record", "take", "--commands")]
    [InlineData("--overwrite", "--overwrite")]
    [InlineData("--colour", "--colour")]
    [InlineData("studio", "studio")]
    public async Task Wrong_options_are_named_with_the_usage_and_end_with_2(string named, params string[] args)
    {
        MonitorResult result = await MonitorRunner.RunAsync(args);

        Assert.Equal(2, result.ExitCode);
        Assert.Empty(result.Output);
        Assert.Contains(named, result.Error[0], StringComparison.Ordinal);
        Assert.Contains(result.Error, static line => line.StartsWith("Usage: neuron-monitor", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Help_names_every_option_and_ends_with_0()
    {
        MonitorResult result = await MonitorRunner.RunAsync("--help");

        Assert.Equal(0, result.ExitCode);
        Assert.Empty(result.Error);
        string text = string.Join('\n', result.Output);
        foreach (string option in (string[])["--connect", "--udp", "--allow-sender", "--demo", "--diagnose", "--commands", "--avatar", "--zero-out", "--bvh-header", "--order", "--command-port", "--once", "--frames", "--duration", "--json", "--quiet", "--info", "--convert", "--plot", "--resample", "--from", "--to", "--play", "--speed", "--rate", "--loop", "--record", "--record-compress", "--record-size", "--record-time", "--record-files", "--overwrite", "--version"])
            Assert.Contains($"  {option} ", text, StringComparison.Ordinal);

        Assert.Contains("Examples:", text, StringComparison.Ordinal);
    }
}
