using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Watch;

public sealed class RecordingTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("neuronmocap-");

    private string Take => Path.Combine(_folder.FullName, "take.nmrec");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData("--json")]
    [InlineData("--quiet")]
    [InlineData("--record-compress")]
    public async Task A_recording_holds_what_was_sent_and_is_summarized(string option)
    {
        byte[] sent = [.. FrameServer.Motion(1, new float[354]), .. "noise"u8, .. FrameServer.Calculation(2, 1, 2)];
        using FrameServer server = FrameServer.Sending(sent);
        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--once", "--record", Take, option);

        Assert.Equal(0, result.ExitCode);
        Assert.Equal(sent, Read(Take));
        string line = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: recorded ", line, StringComparison.Ordinal);
        Assert.Contains($" {sent.Length:#,0} bytes in ", line, StringComparison.Ordinal);
        Assert.EndsWith($"to {Take}; lost 0 pieces.", line, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_device_is_refused_as_a_recording()
    {
        Assert.SkipUnless(File.Exists("/dev/null"), "There is no /dev/null.");
        ToolResult result = await ToolRunner.RunAsync("watch", "--frames", "2", "--quiet", "--record", "/dev/null");

        Assert.Equal(1, result.ExitCode);
        string error = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: --record: '/dev/null' is a ", error, StringComparison.Ordinal);
        Assert.EndsWith("; only regular files are written.", error, StringComparison.Ordinal);
    }

    // The second file is a device that is always full.
    [Theory]
    [InlineData("--json")]
    [InlineData("--quiet")]
    [InlineData("--once")]
    public async Task A_full_disk_is_reported_and_ends_with_1(string output)
    {
        using FullDevice full = await FullDevice.LinkAsync(Path.Combine(_folder.FullName, "take.0002.nmrec"));
        byte[] frame = FrameServer.Motion(1, new float[354]);
        using FrameServer server = FrameServer.Sending([.. Enumerable.Range(0, 2000).Select(_ => frame)]);
        ToolResult result = await ToolRunner.RunAsync(
            "watch", server.Address, "--once", output, "--overwrite", "--record", Take, "--record-size", "2");

        Assert.Equal(1, result.ExitCode);
        Assert.Contains(result.Error, line => line.Contains("the recording ended early: ", StringComparison.Ordinal));
        string told = output switch
        {
            "--json" => Assert.Single(result.OfType("fileFailed")),
            "--quiet" => result.Error[0],
            _ => Assert.Single(result.Output, line => line.Contains("Recording failed: the disk is full.", StringComparison.Ordinal)),
        };
        Assert.Contains("the disk is full.", told, StringComparison.Ordinal);

        // The reported numbers match the content of the file.
        using RecordingReader reader = RecordingReader.Open(Path.Combine(_folder.FullName, "take.0001.nmrec"));
        Assert.Contains(result.Error, line => line.Contains($"recorded ", StringComparison.Ordinal) && line.Contains($" {reader.Totals!.Value.Bytes:#,0} bytes in", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_stream_without_outputs_ends()
    {
        using FullDevice full = await FullDevice.LinkAsync(Path.Combine(_folder.FullName, "take.0002.nmrec"));
        byte[] packet = FrameServer.Motion(1, new float[354]);
        using FrameServer server = FrameServer.Pacing(_ => packet);
        ToolResult result = await ToolRunner.RunAsync(
            "watch", server.Address, "--quiet", "--overwrite", "--record", Take, "--record-size", "2");
        Assert.Equal(1, result.ExitCode);
    }

    [Fact]
    public async Task The_demo_is_recorded_with_metadata()
    {
        ToolResult result = await ToolRunner.RunAsync("watch", "--record", Take, "--frames", "5", "--order", "ZXY", "--quiet");
        Assert.Equal(0, result.ExitCode);
        using RecordingReader reader = RecordingReader.Open(Take);
        Assert.True(reader.IsComplete);
        Assert.Equal(RotationOrder.ZXY, reader.Metadata.RotationOrder);
        Assert.Equal("Binary", reader.Metadata[RecordingMetadata.StreamFormatKey]);
        Assert.Equal("Tcp", reader.Metadata[RecordingMetadata.TransportKey]);
        Assert.Contains("NeuronMocap 0.", reader.Metadata[RecordingMetadata.ProgramKey], StringComparison.Ordinal);
        Assert.Equal(10_224, reader.Metadata.MaxValues);
        Assert.InRange(reader.Totals!.Value.Bytes, 5 * 1480, 500 * 1480);
    }

    [Fact]
    public async Task An_existing_file_is_an_error_unless_overwritten()
    {
        await File.WriteAllTextAsync(Take, "precious", TestContext.Current.CancellationToken);
        ToolResult refused = await ToolRunner.RunAsync("watch", "--record", Take, "--frames", "1", "--quiet");
        Assert.Equal(1, refused.ExitCode);
        Assert.Contains("--overwrite replaces", Assert.Single(refused.Error), StringComparison.Ordinal);
        Assert.Equal("precious", await File.ReadAllTextAsync(Take, TestContext.Current.CancellationToken));

        ToolResult replaced = await ToolRunner.RunAsync("watch", "--record", Take, "--overwrite", "--frames", "1", "--quiet");
        Assert.Equal(0, replaced.ExitCode);
        Assert.NotEmpty(Read(Take));
    }

    [Fact]
    public async Task A_missing_folder_is_named()
    {
        ToolResult result = await ToolRunner.RunAsync("watch", "--record", Path.Combine(_folder.FullName, "missing", "take.nmrec"), "--frames", "1");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("missing", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.DoesNotContain("--overwrite", result.Error[0], StringComparison.Ordinal);
    }

    private static byte[] Read(string path)
    {
        using RecordingReader reader = RecordingReader.Open(path);
        var bytes = new MemoryStream();
        while (reader.TryRead(out RecordingEntry entry))
            bytes.Write(entry.Bytes);

        Assert.Empty(reader.Problems);
        return bytes.ToArray();
    }
}
