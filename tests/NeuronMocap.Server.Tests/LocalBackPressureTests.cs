namespace NeuronMocap.Server.Tests;

// A reader in the same process whose queue waits for room.
public sealed class LocalBackPressureTests
{
    private static readonly FrameQueueOptions Waiting = new() { Capacity = 4, WhenFull = WhenFull.Wait };

    [Fact]
    public async Task An_unpaced_broadcast_waits_for_the_queue_and_loses_nothing()
    {
        const int Frames = 500;
        using Broadcaster broadcaster = Broadcasts.Started(Unpaced(Frames));
        await using var reader = new NeuronReader(new NeuronReaderOptions { Source = broadcaster.CreateLocalSource() });
        using FrameQueue queue = reader.OpenQueue(Waiting);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 5 && reader.IsDelivering);
        Assert.Equal((4, 5), (queue.Count, reader.GetStatistics().MotionFrames));

        List<uint?> indices = [];
        while (indices.Count < Frames && await queue.WaitAsync(TestContext.Current.CancellationToken).Soon())
            queue.Pump<MotionFrame>(frame => indices.Add(frame.FrameIndex));

        await broadcaster.Completion.Soon();
        Assert.Equal(Enumerable.Range((int)indices[0]!.Value, Frames).Select(static index => (uint?)index), indices);
        Assert.Equal((Frames, 0, 0), (queue.Delivered, queue.Dropped, broadcaster.GetStatistics().PacketsDropped));
    }

    // Either end stops while the reader's thread waits for room.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task Stopping_either_end_ends_the_wait(bool stopsBroadcaster)
    {
        using Broadcaster broadcaster = Broadcasts.Started(Unpaced(frames: null));
        await using var reader = new NeuronReader(new NeuronReaderOptions { Source = broadcaster.CreateLocalSource(), Reconnect = { Enabled = false } });
        using FrameQueue queue = reader.OpenQueue(Waiting);
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 5 && reader.IsDelivering);
        if (stopsBroadcaster)
        {
            await Task.Run(broadcaster.Dispose, TestContext.Current.CancellationToken).Soon();
            queue.Dispose();
        }
        else
        {
            await reader.DisposeAsync().AsTask().Soon();
        }

        await reader.Completion.Soon();
        await Limits.UntilAsync(() => broadcaster.GetClients().Count == 0);
    }

    private static BroadcasterOptions Unpaced(int? frames)
    {
        var options = new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, FrameRate = BroadcasterOptions.MaxFrameRate };
        if (frames is { } limit)
            options.MaxFrames = limit;

        return options;
    }
}
