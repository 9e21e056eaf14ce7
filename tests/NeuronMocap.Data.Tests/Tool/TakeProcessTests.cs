using System.Globalization;
using System.Runtime.InteropServices;
using System.Text.Json;
using NeuronMocap.Calculation;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Data.Tests.Tool;

// Sends the recorded take from one program to another, and reads it back from the monitor's JSON lines.
public sealed class TakeProcessTests
{
    [Theory]
    [InlineData("1480")]
    [InlineData("7")]
    public async Task Every_value_of_the_file_reaches_watch(string fragment)
    {
        string file = Fixtures.Require("test-take", "test.bvh");
        using var simulator = new ToolProcess(
            "neuron-mocap simulate", "--bvh", file, "--port", "0", "--rate", "max", "--wait-for-client", "--fragment", fragment, "--displacement", "off");
        string? line;
        do
            line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        while (line?.StartsWith("Listening on ", StringComparison.Ordinal) == false);

        using var monitor = new ToolProcess("neuron-mocap", "watch", line!["Listening on ".Length..], "--once", "--json");
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

    // A broadcast of an export: the program says what it plays, and each motion frame is followed by the file's own values.
    [Fact]
    public async Task A_calculation_export_is_broadcast_unchanged()
    {
        string file = Fixtures.Require("calc", "hiphop_up_Char00.calc");
        using var simulator = new ToolProcess(
            "neuron-mocap simulate", "--calc", file, "--calculation", "--port", "0", "--rate", "max", "--wait-for-client");
        string output = "";
        string? line;
        do
            output += line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        while (line?.StartsWith("Listening on ", StringComparison.Ordinal) == false);

        CalculationDocument document = CalculationDocument.Load(file);
        int motion = 0;
        int calculation = 0;
        await using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Port = int.Parse(line!.Split(':')[^1], CultureInfo.InvariantCulture),
            Reconnect = { Enabled = false },
        });
        reader.MotionReceived += _ => motion++;
        reader.CalculationReceived += frame =>
            Assert.True(MemoryMarshal.AsBytes(document.GetValues(calculation++)).SequenceEqual(MemoryMarshal.AsBytes(frame.Values)));
        List<Exception> failures = [];
        reader.CallbackFailed += failures.Add;
        reader.Start();
        await reader.Completion.WaitAsync(TimeSpan.FromMinutes(1), TestContext.Current.CancellationToken);

        Assert.Empty(failures);
        Assert.Equal((172, 172), (motion, calculation));
        Assert.Contains("hiphop_up_Char00.calc: 172 frames at 120 Hz", output, StringComparison.Ordinal);
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    private static int Bits(string text) => BitConverter.SingleToInt32Bits(float.Parse(text, CultureInfo.InvariantCulture));
}
