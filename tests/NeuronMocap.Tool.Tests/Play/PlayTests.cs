using System.Text.Json;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.Watch.Playback;

namespace NeuronMocap.Tool.Tests.Play;

public sealed class PlayTests : IDisposable
{
    private readonly string _recording = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".nmrec");
    private readonly string _dump = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".bin");

    public PlayTests()
    {
        using RecordingWriter writer = RecordingWriter.Create(_recording);
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, string.Empty, string.Empty));
        for (int frame = 0; frame < 10; frame++)
            writer.WriteBytes(TimeSpan.FromMilliseconds(frame * 10), 0, FrameServer.Motion((uint)frame, frame));

        File.WriteAllBytes(_dump, [.. Enumerable.Range(0, 10).SelectMany(static frame => FrameServer.Motion((uint)frame, frame))]);
    }

    public void Dispose()
    {
        File.Delete(_recording);
        File.Delete(_dump);
    }

    [Theory]
    [InlineData(true, "--speed", "max")]
    [InlineData(true, "--speed", "100")]
    [InlineData(false, "--rate", "1000")]
    public async Task Play_prints_every_frame_of_a_file_and_ends_with_0(bool isRecording, params string[] how)
    {
        ToolResult result = await ToolRunner.RunAsync([.. (string[])["play", isRecording ? _recording : _dump, "--json"], .. how]);
        Assert.Empty(result.Error);
        Assert.Equal(0, result.ExitCode);
        Assert.Equal(
            Enumerable.Range(0, 10),
            result.OfType("frame").Select(static line => JsonDocument.Parse(line).RootElement.GetProperty("index").GetInt32()));
        Assert.Contains("has ended", string.Join('\n', result.Output), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Play_can_export_BVH()
    {
        string target = _dump + ".bvh";
        await File.WriteAllBytesAsync(
            _dump, [.. Enumerable.Range(0, 10).SelectMany(static frame => FrameServer.Motion((uint)frame, new float[354]))], TestContext.Current.CancellationToken);
        ToolResult result = await ToolRunner.RunAsync("play", _dump, "--rate", "60", "--speed", "max", "--quiet", "--export", target);
        Assert.Equal(0, result.ExitCode);
        Assert.Contains("10 frames of Char00 at 60 Hz", Assert.Single(result.Error), StringComparison.Ordinal);
        Assert.Equal(10, BvhDocument.Load(target).FrameCount);
        File.Delete(target);
    }

    [Fact]
    public async Task A_loop_ends_at_the_frame_limit()
    {
        ToolResult result = await ToolRunner.RunAsync("play", _recording, "--loop", "--speed", "max", "--frames", "35", "--json");
        Assert.Equal(0, result.ExitCode);
        Assert.Equal(35, result.OfType("frame").Length);
    }

    [Fact]
    public async Task An_unplayable_file_is_named_and_ends_with_1()
    {
        await File.WriteAllTextAsync(_dump, "HIERARCHY", TestContext.Current.CancellationToken);
        ToolResult other = await ToolRunner.RunAsync("play", _dump);
        Assert.Equal((1, $"neuron-mocap: '{_dump}' is a BVH file, not a recording of a stream. neuron-mocap convert turns it into one."), (other.ExitCode, Assert.Single(other.Error)));
        ToolResult missing = await ToolRunner.RunAsync("play", _dump + "x");
        Assert.Equal((1, true), (missing.ExitCode, Assert.Single(missing.Error) == $"neuron-mocap: '{_dump}x' does not exist."));
        ToolResult timed = await ToolRunner.RunAsync("play", _recording, "--rate", "60");
        Assert.Equal((1, true), (timed.ExitCode, Assert.Single(timed.Error).Contains("--rate", StringComparison.Ordinal)));
    }

    [Theory]
    [InlineData("'studio'", "play", "x", "studio")]
    [InlineData("--calculation-port", "play", "x", "--calculation-port", "7003")]
    [InlineData("FILE", "play")]
    [InlineData("--once", "play", "x", "--once")]
    [InlineData("--once", "watch", "./x", "--once")]
    [InlineData("convert", "watch", "./x", "--record", "y")]
    [InlineData("FILE and --export name the same file", "play", "x", "--export", "./x", "--overwrite")]
    [InlineData("--export and --record name the same file", "watch", "--export", "x", "--record", "x")]
    [InlineData("--speed", "watch", "--speed", "2")]
    [InlineData("--speed", "play", "x", "--speed", "0")]
    [InlineData("--speed", "play", "x", "--speed", "101")]
    [InlineData("--rate", "watch", "--rate", "60")]
    [InlineData("--loop", "watch", "--loop")]
    public async Task Contradictions_are_named_and_end_with_2(string named, params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync(args);
        Assert.Equal(2, result.ExitCode);
        Assert.Contains(named, result.Error[0], StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_simulator_sends_a_recording_to_watch()
    {
        using var simulator = new ToolProcess("neuron-mocap simulate", "--play", _recording, "--port", "0", "--wait-for-client", "--speed", "10");
        string? line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        Assert.Equal($"Playing {Path.GetFileName(_recording)}: 0.1 s, speed 10", line);
        line = await simulator.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        ToolResult result = await ToolRunner.RunAsync("watch", line!["Listening on ".Length..], "--once", "--json");
        Assert.Equal((0, 10), (result.ExitCode, result.OfType("frame").Length));
        Assert.Equal(0, await simulator.WaitForExitAsync());
    }

    [Theory]
    [InlineData(1, "--play:", "--play", "no such file")]
    [InlineData(2, "--rate:", "--play", "FILE", "--rate", "60")]
    [InlineData(2, "--avatars", "--play", "FILE", "--avatars", "2")]
    [InlineData(2, "--command-port", "--play", "FILE", "--command-port")]
    [InlineData(2, "--bvh", "--play", "FILE", "--bvh", "x.bvh")]
    [InlineData(2, "--speed", "--speed", "2")]
    [InlineData(2, "--speed", "--play", "FILE", "--speed", "0")]
    [InlineData(2, "--speed", "--play", "FILE", "--speed", "2", "--rate", "max")]
    public async Task The_simulator_names_the_wrong_option(int code, string named, params string[] args)
    {
        string[] real = [.. args.Select(argument => argument == "FILE" ? _recording : argument)];
        ToolResult result = await ToolRunner.RunAsync(["simulate", .. real]);
        Assert.Equal(code, result.ExitCode);
        Assert.Contains(named, string.Join('\n', result.Error), StringComparison.Ordinal);
    }

    [Fact]
    public void Keys_control_the_playback()
    {
        using RecordingPlayer player = RecordingPlayer.Open(_recording);
        Assert.Equal("0:00.0 of 0:00.0", PlaybackKeys.Describe(player));
        Assert.True(Press(player, ' '));
        Assert.True(player.IsPaused);
        Assert.True(Press(player, ' '));
        Assert.False(player.IsPaused);
        Assert.True(Press(player, '-') && Press(player, '-'));
        Assert.Equal(0.25, player.Speed);
        player.Seek(TimeSpan.FromMilliseconds(50));
        Assert.True(PlaybackKeys.TryHandle(player, new ConsoleKeyInfo('\0', ConsoleKey.RightArrow, shift: false, alt: false, control: false)));
        Assert.Equal(player.Duration, player.Position);
        Assert.True(PlaybackKeys.TryHandle(player, new ConsoleKeyInfo('\0', ConsoleKey.LeftArrow, shift: false, alt: false, control: false)));
        Assert.Equal(TimeSpan.Zero, player.Position);
        Assert.True(Press(player, '.'));
        Assert.Equal("0:00.000 of 0:00.0, 0.25x, paused", PlaybackKeys.Describe(player));
        Assert.False(Press(player, 'q'));
        player.Speed = RecordingPlayer.MaxSpeed;
        Assert.True(Press(player, '+') && Press(player, '-'));
        Assert.Equal(50, player.Speed);
        Assert.True(Press(player, '0'));
        Assert.Equal(1, player.Speed);
    }

    private static bool Press(RecordingPlayer player, char key) =>
        PlaybackKeys.TryHandle(player, new ConsoleKeyInfo(key, ConsoleKey.None, shift: false, alt: false, control: false));
}
