using System.Text;
using System.Text.Json;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Relay;

// What relay writes to its standard output for other programs.
public sealed class RelayOutputTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Json_lists_the_destinations_then_figures_and_events_and_ends_with_the_totals()
    {
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        using var output = new CountingStream("\"type\":\"received\"", count: 2, () => _ = stop.CancelAsync());
        using var error = new StringWriter();
        using var streams = new StandardStreams(output, error, IsTerminal: false);
        Task<int> running = CommandLine.RunAsync(["relay", "demo", "tcp://127.0.0.1:0", _folder["copy.nmrec"], "--json"], streams, stop.Token);
        Assert.Equal(0, await running.Soon());
        List<JsonElement> lines = [.. Encoding.UTF8.GetString(output.ToArray()).Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(Parse)];
        Assert.Equal("demo", lines[0].GetProperty("source").GetString());
        Assert.Equal(["start", "opened", "opened"], lines.Take(3).Select(TypeOf));
        Assert.StartsWith("tcp://127.0.0.1:", lines[1].GetProperty("destination").GetString(), StringComparison.Ordinal);
        Assert.False(lines[1].GetProperty("destination").GetString()!.EndsWith(":0", StringComparison.Ordinal));
        Assert.Equal((_folder["copy.nmrec"], "pieces"), (lines[2].GetProperty("destination").GetString(), lines[2].GetProperty("unit").GetString()));
        Assert.Contains(lines, static line => TypeOf(line) == "status" && line.GetProperty("state").GetString() == "Receiving");

        // One line of each destination for each line of the source.
        JsonElement[] received = [.. lines.Where(static line => TypeOf(line) == "received")];
        JsonElement[] flows = [.. lines.Where(static line => TypeOf(line) == "flow")];
        Assert.True(received.Length >= 2);
        Assert.Equal(2 * received.Length, flows.Length);
        Assert.Equal("waiting", flows[0].GetProperty("state").GetString());
        Assert.Equal(0, flows[0].GetProperty("clients").GetInt32());
        Assert.Equal(JsonValueKind.Null, flows[1].GetProperty("clients").ValueKind);

        JsonElement summary = lines[^1];
        Assert.Equal("summary", TypeOf(summary));
        JsonElement[] totals = [.. summary.GetProperty("destinations").EnumerateArray()];
        Assert.Equal(RelayRunTests.ReadBytes(_folder["copy.nmrec"]).Length, totals[1].GetProperty("bytes").GetInt64());
        Assert.True(totals[1].GetProperty("sent").GetInt64() >= flows[1].GetProperty("sent").GetInt64());
        Assert.True(summary.GetProperty("frames").GetInt64() >= received[^1].GetProperty("frames").GetInt64());
    }

    [Fact]
    public async Task Quiet_writes_only_the_totals()
    {
        RelayRunTests.WriteRecording(_folder["take.nmrec"], [.. Enumerable.Range(0, 40).Select(static index => FrameServer.Motion((uint)index, new float[354]))]);
        ToolResult result = await ToolRunner.RunAsync("relay", _folder["take.nmrec"], _folder["copy.bvh"], "--quiet");
        Assert.Equal(0, result.ExitCode);
        JsonElement summary = Parse(Assert.Single(result.Output));
        Assert.Equal(("summary", 40), (TypeOf(summary), summary.GetProperty("frames").GetInt32()));
        JsonElement copy = Assert.Single(summary.GetProperty("destinations").EnumerateArray());
        Assert.Equal((_folder["copy.bvh"], 40, 0), (copy.GetProperty("destination").GetString(), copy.GetProperty("sent").GetInt32(), copy.GetProperty("dropped").GetInt32()));
    }

    [Fact]
    public async Task A_file_that_fails_is_an_event_in_json()
    {
        using FullDevice full = await FullDevice.LinkAsync(_folder["full.bvh"]);
        RelayRunTests.WriteRecording(_folder["take.nmrec"], [.. Enumerable.Range(0, 40).Select(static index => FrameServer.Motion((uint)index, new float[354]))]);
        ToolResult result = await ToolRunner.RunAsync("relay", _folder["take.nmrec"], _folder["full.bvh"], "--overwrite", "--json");
        Assert.Equal(1, result.ExitCode);
        JsonElement failed = Assert.Single(result.Output.Select(Parse), static line => TypeOf(line) == "fileFailed");
        Assert.Equal(("export", _folder["full.bvh"]), (failed.GetProperty("kind").GetString(), failed.GetProperty("file").GetString()));
        Assert.NotNull(Assert.Single(Parse(result.Output[^1]).GetProperty("destinations").EnumerateArray()).GetProperty("failure").GetString());
    }

    [Theory]
    [InlineData]
    [InlineData("--json")]
    [InlineData("--quiet")]
    public async Task An_output_that_nobody_reads_holds_up_nothing(params string[] options)
    {
        using var output = new StuckStream();
        RelayRunTests.WriteRecording(_folder["take.nmrec"], [.. Enumerable.Range(0, 40).Select(static index => FrameServer.Motion((uint)index, new float[354]))]);
        ToolResult result = await ToolRunner.RunAsync(output, ["relay", _folder["take.nmrec"], _folder["copy.nmrec"], .. options]);
        Assert.Equal(0, result.ExitCode);
        Assert.Equal(RelayRunTests.ReadBytes(_folder["take.nmrec"]), RelayRunTests.ReadBytes(_folder["copy.nmrec"]));
        output.Release();
    }

    private static JsonElement Parse(string line) => JsonDocument.Parse(line).RootElement;

    private static string? TypeOf(JsonElement line) => line.GetProperty("type").GetString();

    // Calls the action once so many lines have contained a text.
    private sealed class CountingStream(string text, int count, Action then) : MemoryStream
    {
        private int _count;

        public override void Write(ReadOnlySpan<byte> buffer)
        {
            base.Write(buffer);
            if (Encoding.UTF8.GetString(buffer).Contains(text, StringComparison.Ordinal) && ++_count == count)
                then();
        }
    }

    // A pipe that is full.
    private sealed class StuckStream : MemoryStream
    {
        private readonly ManualResetEventSlim _released = new();

        public void Release() => _released.Set();

        public override void Write(ReadOnlySpan<byte> buffer) => _released.Wait();

        public override void Write(byte[] buffer, int offset, int count) => _released.Wait();
    }
}
