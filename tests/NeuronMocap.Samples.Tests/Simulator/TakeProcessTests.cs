using System.Globalization;
using System.Text.Json;
using NeuronMocap.Samples.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Samples.Tests.Simulator;

// The recorded take from one program to the other, read back from the monitor's JSON lines.
public sealed class TakeProcessTests
{
    [Theory]
    [InlineData("1480")]
    [InlineData("7")]
    public async Task Every_value_of_the_file_comes_out_of_the_monitor(string fragment)
    {
        string file = Fixtures.Require("test-take", "test.bvh");
        using var simulator = new SampleProcess(
            "neuron-simulator", "--bvh", file, "--port", "0", "--rate", "max", "--wait-for-client", "--fragment", fragment, "--displacement", "off");
        string? line;
        do
            line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        while (line?.StartsWith("Listening on ", StringComparison.Ordinal) == false);

        using var monitor = new SampleProcess("neuron-monitor", "--connect", line!["Listening on ".Length..], "--once", "--json");
        string[] rows = [.. File.ReadLines(file).SkipWhile(row => !row.StartsWith("Frame Time", StringComparison.Ordinal)).Skip(1)];
        int frame = 0;
        while (await monitor.Output.ReadLineAsync(TestContext.Current.CancellationToken) is { } json)
        {
            using JsonDocument document = JsonDocument.Parse(json);
            if (document.RootElement.GetProperty("type").GetString() != "frame")
                continue;

            Assert.Equal(frame, document.RootElement.GetProperty("index").GetInt32());
            IEnumerable<int> expected = rows[frame++].Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(text => Bits(text.Trim()));
            Assert.Equal(expected, document.RootElement.GetProperty("values").EnumerateArray().Select(value => Bits(value.GetRawText())));
        }

        Assert.Equal(2156, frame);
        Assert.Equal(0, await monitor.WaitForExitAsync());
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    private static int Bits(string text) => BitConverter.SingleToInt32Bits(float.Parse(text, CultureInfo.InvariantCulture));
}
