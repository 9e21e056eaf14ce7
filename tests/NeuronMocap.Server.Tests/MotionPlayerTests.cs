using System.Numerics;
using NeuronMocap.Recording;
using NeuronMocap.Server.Tests.Sources;
using NeuronMocap.Tests.Playback;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

public sealed class MotionPlayerTests
{
    private static readonly TimeSpan Frame = TimeSpan.FromTicks(TimeSpan.TicksPerSecond / 60);

    private readonly ManualClock _clock = new();

    [Fact]
    public async Task A_reader_gets_the_frames_of_a_broadcast()
    {
        var source = new TestSource(seed: 3, frameCount: 90);
        string[] broadcast;
        await using (var server = new Broadcaster(new BroadcasterOptions
        {
            Sources = [source],
            AvatarNames = ["Ann"],
            Port = 0,
            IncludeDisplacement = true,
            FrameRate = BroadcasterOptions.MaxFrameRate,
            WaitForClient = true,
        }))
        {
            server.Start();
            await using var client = new NeuronReader("127.0.0.1", server.LocalEndPoint!.Port);
            using var received = new FrameLog(client);
            client.Start();
            await received.WaitAsync(90);
            broadcast = received.Lines;
        }

        using RecordingPlayer player = MotionPlayer.Create(source, "Ann", new PlaybackOptions { Clock = _clock });
        Assert.Equal(Frame.TotalSeconds * 90, player.Duration.TotalSeconds, 1e-5);
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        reader.Start();
        await frames.WaitAsync(1);
        Assert.Contains("motion Ann", reader.Status.Message, StringComparison.Ordinal);
        _clock.MoveTo(TimeSpan.FromMinutes(1));
        await reader.Completion.Soon();

        Assert.Equal(broadcast, frames.Lines);
        Assert.Equal(ConnectionReason.EndOfRecording, reader.Status.Reason);
    }

    [Fact]
    public async Task An_endless_source_never_ends_and_can_seek()
    {
        using RecordingPlayer player = MotionPlayer.Create(new LoopedSource(new TestSource(frameCount: 60)), "Ann", new PlaybackOptions { Clock = _clock });
        Assert.Equal(TimeSpan.MaxValue, player.Duration);
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        reader.Start();
        await frames.WaitAsync(1);
        _clock.MoveTo(TimeSpan.FromSeconds(5));
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.Equal(301, frames.Indices.Length);

        frames.Clear();
        player.Seek(TimeSpan.FromSeconds(100));
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.Equal(6000u, Assert.Single(frames.Indices));
        player.Seek(TimeSpan.Zero);
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.Equal(0u, frames.Indices[^1]);
    }

    // The stop does not wait for the thread that it runs on, so it is complete at once.
    [Fact]
    public async Task A_source_can_stop_the_reader_at_once()
    {
        bool? isStopped = null;
        Action stop = static () => { };
        var source = new FormulaSource(60, 90, (_, pose) =>
        {
            pose.Fill(new BoneTransform(Vector3.Zero, Quaternion.Identity));
            stop();
        });
        using RecordingPlayer player = MotionPlayer.Create(source, "Ann");
        await using var reader = new NeuronReader(player, new NeuronReaderOptions { StopTimeout = Limits.Unexpected });
        stop = () => isStopped ??= reader.DisposeAsync().AsTask().IsCompleted;
        reader.Start();
        await reader.Completion.Soon();
        await Limits.UntilAsync(() => isStopped is not null);
        Assert.True(isStopped);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(100)]
    public async Task An_endless_source_continues_after_the_last_position(double speed)
    {
        using RecordingPlayer player = MotionPlayer.Create(new SyntheticSource(60), "Ann", new PlaybackOptions { Clock = _clock });
        await using var reader = new NeuronReader(player);
        using var frames = new FrameLog(reader);
        reader.Start();
        await frames.WaitAsync(1);
        player.Seek(player.Duration);
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        TimeSpan last = player.Position;
        Assert.InRange(last, TimeSpan.FromDays(3600 * 365), player.Duration - TimeSpan.FromDays(1));

        player.Pause();
        player.Speed = speed;
        player.Resume();
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        frames.Clear();
        _clock.MoveTo(TimeSpan.FromSeconds(1));
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.InRange(frames.Indices.Length, (60 * speed) - 1, (60 * speed) + 1);
        Assert.Equal(last + TimeSpan.FromSeconds(speed), player.Position);

        player.StepBack();
        await Limits.UntilAsync(() => player.Position < last + TimeSpan.FromSeconds(speed));
        player.Seek(TimeSpan.Zero);
        player.Resume();
        Assert.True(player.WaitUntilDelivered(Limits.Unexpected));
        Assert.Equal(0u, frames.Indices[^1]);
    }

    [Fact]
    public void A_source_longer_than_a_time_can_be_lasts_as_long_as_a_time()
    {
        using RecordingPlayer player = MotionPlayer.Create(new FormulaSource(0.01, long.MaxValue - 1, static (_, _) => { }), "Ann");
        Assert.Equal(TimeSpan.MaxValue, player.Duration);
    }

    [Fact]
    public void Null_arguments_are_rejected()
    {
        Assert.Throws<ArgumentNullException>(static () => MotionPlayer.Create(null!, "Ann"));
        Assert.Throws<ArgumentNullException>(static () => MotionPlayer.Create(new TestSource(), null!));
    }
}
