using NeuronMocap.Bvh;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Watch;

public sealed class ExportTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("neuronmocap");

    private string Target => Path.Combine(_folder.FullName, "take.bvh");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData("--json")]
    [InlineData("--quiet")]
    [InlineData("--once")]
    public async Task Shown_frames_are_exported(string output)
    {
        using FrameServer server = FrameServer.Sending(FrameServer.Motion(1, Values(1)), FrameServer.Motion(2, Values(2)), FrameServer.Motion(4, Values(4)));

        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--once", output, "--export", Target);

        Assert.Equal(0, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.StartsWith("neuron-mocap: 3 frames of Char00 at ", line, StringComparison.Ordinal);
        Assert.EndsWith($"Hz in {Target}; lengths of the bones of the default body.", line, StringComparison.Ordinal);
        BvhDocument take = BvhDocument.Load(Target);
        Assert.Equal([1f, 2, 4], Enumerable.Range(0, 3).Select(frame => take.GetValues(frame)[179]));
    }

    [Fact]
    public async Task The_frame_limit_applies_to_the_export()
    {
        using FrameServer server = FrameServer.Repeating(FrameServer.Motion(1, Values(1)));
        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--quiet", "--frames", "7", "--export", Target);

        Assert.Equal(0, result.ExitCode);
        Assert.Equal(7, BvhDocument.Load(Target).FrameCount);
    }

    [Fact]
    public async Task The_demo_can_be_exported()
    {
        ToolResult result = await ToolRunner.RunAsync("watch", "demo", "--quiet", "--frames", "5", "--export", Target);
        Assert.Equal(0, result.ExitCode);
        Assert.Contains("5 frames of Demo at", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_existing_file_is_replaced_only_by_option()
    {
        await File.WriteAllTextAsync(Target, "precious", TestContext.Current.CancellationToken);
        using FrameServer server = FrameServer.Sending(FrameServer.Motion(1, Values(1)));

        ToolResult refused = await ToolRunner.RunAsync("watch", server.Address, "--once", "--quiet", "--export", Target);
        Assert.Equal(1, refused.ExitCode);
        Assert.EndsWith("--overwrite replaces it.", Assert.Single(refused.Error), StringComparison.Ordinal);
        Assert.Equal("precious", await File.ReadAllTextAsync(Target, TestContext.Current.CancellationToken));

        ToolResult replaced = await ToolRunner.RunAsync("watch", server.Address, "--once", "--quiet", "--export", Target, "--overwrite");
        Assert.Equal(0, replaced.ExitCode);
        Assert.Equal(1, BvhDocument.Load(Target).FrameCount);
    }

    [Fact]
    public async Task Every_avatar_gets_a_file_when_asked_for()
    {
        var header = new MotionHeader { AvatarName = new AvatarName("Two"), AvatarIndex = 2, FrameIndex = 1 };
        using FrameServer server = FrameServer.Sending(FrameServer.Motion(1, Values(1)), FrameServer.Motion(header, Values(9)));

        ToolResult result = await ToolRunner.RunAsync(
            "watch", server.Address, "--once", "--quiet", "--export", Target, "--export-avatar", "all");
        Assert.Equal(2, result.Error.Length);
        Assert.Equal(9, BvhDocument.Load(Path.Combine(_folder.FullName, "take-avatar2.bvh")).GetValues(0)[0]);

        await ToolRunner.RunAsync("watch", server.Address, "--once", "--quiet", "--export", Target, "--export-avatar", "2");
        Assert.Equal(9, BvhDocument.Load(Target).GetValues(0)[0]);
    }

    [Fact]
    public async Task No_file_is_left_without_a_frame()
    {
        using FrameServer server = FrameServer.Sending(FrameServer.Calculation(1, 2));
        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--once", "--quiet", "--export", Target);

        Assert.Equal("neuron-mocap: no motion frame arrived, so no file was written.", Assert.Single(result.Error));
        Assert.False(File.Exists(Target));
    }

    // The file is a device that is always full.
    [Theory]
    [InlineData("--json")]
    [InlineData("--quiet")]
    [InlineData("--once")]
    public async Task A_full_disk_is_reported_and_ends_with_1(string output)
    {
        using FullDevice full = await FullDevice.LinkAsync(Target);
        using FrameServer server = FrameServer.Sending(FrameServer.Motion(1, Values(1)), FrameServer.Motion(2, Values(2)));
        ToolResult result = await ToolRunner.RunAsync("watch", server.Address, "--once", output, "--overwrite", "--export", Target);

        Assert.Equal(1, result.ExitCode);
        Assert.Contains(result.Error, line => line.Contains($"the export ended early: '{Target}': the disk is full.", StringComparison.Ordinal));
        Assert.Contains("neuron-mocap: 2 frames could not be written; later frames were not exported.", result.Error);
        Assert.DoesNotContain(result.Error, line => line.Contains("no motion frame arrived", StringComparison.Ordinal));
        string told = output switch
        {
            "--json" => Assert.Single(result.OfType("fileFailed")),
            "--quiet" => result.Error[0],
            _ => Assert.Single(result.Output, line => line.Contains("Export failed: the disk is full.", StringComparison.Ordinal)),
        };
        Assert.Contains("the disk is full.", told, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_file_being_written_is_left_alone()
    {
        string recorded = Path.Combine(_folder.FullName, "take.nmrec");
        File.CreateSymbolicLink(Target, recorded);
        ToolResult result = await ToolRunner.RunAsync("watch", "demo", "--quiet", "--frames", "1", "--overwrite", "--export", Target, "--record", recorded);
        Assert.Equal(1, result.ExitCode);
        string line = Assert.Single(result.Error);
        Assert.Contains($"'{recorded}' is already being written", line, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--overwrite needs --export or --record", "--overwrite")]
    [InlineData("--export-avatar needs --export", "--export-avatar", "1")]
    [InlineData("is not an avatar number", "--export", "a.bvh", "--export-avatar", "-1")]
    public async Task Contradictions_are_refused(string reason, params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync(["watch", .. args]);
        Assert.Equal(2, result.ExitCode);
        Assert.Contains(result.Error, line => line.Contains(reason, StringComparison.Ordinal));
    }

    // kill -9: the program ends at once, and the data that it had passed to the system is in the file.
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public async Task A_killed_process_leaves_a_readable_file(int seed)
    {
        var random = new Random(seed);
        BvhDocument before;
        using (var monitor = new ToolProcess("neuron-mocap", "watch", "demo", "--quiet", "--export", Target))
        {
            while (!File.Exists(Target) || ReadShared() is null)
                await Task.Delay(10, TestContext.Current.CancellationToken);

            await Task.Delay(random.Next(400), TestContext.Current.CancellationToken);
            before = ReadShared()!;
            monitor.Kill();
        }

        BvhDocument after = BvhDocument.Load(Target);
        Assert.True(after.FrameCount >= before.FrameCount, $"{after.FrameCount} of {before.FrameCount} rows.");
        Assert.Equal(before.ChannelCount, after.ChannelCount);
        for (int frame = 0; frame < before.FrameCount; frame++)
            Assert.True(before.GetValues(frame).SequenceEqual(after.GetValues(frame)), $"Row {frame} differs.");

        // The declared number of frames, on which other programs rely, never exceeds the number of rows.
        string declared = File.ReadLines(Target).First(static line => line.StartsWith("Frames:", StringComparison.Ordinal));
        Assert.InRange(int.Parse(declared["Frames:".Length..].Trim(), System.Globalization.CultureInfo.InvariantCulture), 1, after.FrameCount);
    }

    private static float[] Values(float value)
    {
        float[] values = new float[180];
        Array.Fill(values, value);
        return values;
    }

    // Null before the first counted row.
    private BvhDocument? ReadShared()
    {
        using var stream = new FileStream(Target, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        byte[] bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        int frames = bytes.AsSpan().IndexOf("Frames: "u8);
        bool hasRows = frames >= 0 && frames + 8 < bytes.Length && bytes[frames + 8] is > (byte)'0' and <= (byte)'9';
        return hasRows ? BvhDocument.Parse(bytes) : null;
    }
}
