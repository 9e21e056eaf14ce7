using NeuronMocap.Recording;
using NeuronMocap.Tests.Playback;

namespace NeuronMocap.Tests.Delivery;

public sealed class PlaybackDeliveryTests
{
    [Fact]
    public async Task A_playback_at_full_speed_waits_for_the_window()
    {
        const int count = 1000;
        using TemporaryFile file = Played.Frames(count, interval: 1000.0 / 120);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        using var window = new MessageLoop();
        await using var reader = new NeuronReader(player);
        FrameDelivery delivery = window.Invoke(() => reader.OpenDelivery(new FrameDeliveryOptions { Capacity = 8 }));
        uint next = 0;
        delivery.MotionReceived += frame => Assert.Equal(next++, frame.FrameIndex);
        reader.Start();
        Assert.Equal(FrameDeliveryEndReason.ReaderStopped, (await delivery.Completion.Soon()).Reason);
        Assert.Equal((count, count, 0L), ((int)next, (int)delivery.Delivered, delivery.Dropped));
        Assert.Empty(window.Exceptions);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_playback_at_full_speed_does_not_wait_for_a_window_that_is_gone(bool throws)
    {
        const int count = 1000;
        using TemporaryFile file = Played.Frames(count, interval: 1000.0 / 120);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = RecordingPlayer.MaxSpeed;
        using var window = new MessageLoop(throws ? LatePost.Throw : LatePost.Ignore);
        await using var reader = new NeuronReader(player);
        FrameDelivery delivery = window.Invoke(() => reader.OpenDelivery(new FrameDeliveryOptions { Capacity = 8 }));
        window.End();
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal((count, 0L), (reader.GetStatistics().MotionFrames, delivery.Delivered));
    }
}
