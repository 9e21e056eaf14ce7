using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

/// <summary>A queue that waits for room holds up a stream: nothing is read, and nothing is lost.</summary>
public sealed class SourceBackPressureTests
{
    private const int Frames = 200;

    public static TheoryData<ReceiveThread> Threads => SourceReaderTests.Threads;

    [Theory]
    [MemberData(nameof(Threads))]
    public async Task A_stream_is_not_read_while_a_queue_waits(ReceiveThread thread)
    {
        using var stream = new FedStream();
        await using var reader = new NeuronReader(stream, SourceReaderTests.Options(thread));
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = 2, WhenFull = WhenFull.Wait });
        using FrameQueue other = reader.OpenQueue();
        reader.Start();
        for (int frame = 0; frame < Frames; frame++)
            stream.Feed(TestPackets.Motion(frame));

        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 3 && reader.IsDelivering);
        Assert.Equal((2, 0), (queue.Count, stream.Waiting));

        stream.End();
        Assert.Equal(Enumerable.Range(0, Frames).Select(static frame => (float)frame), await TakeAllAsync(queue));
        Assert.Equal((Frames, 0, 0), (queue.Delivered, queue.Dropped, reader.GetStatistics().Lost));
        Assert.Equal(Frames, other.Count);
        await reader.Completion.Soon();
    }

    // The read that is pending or the delivery that waits must not hold up the stop.
    [Theory]
    [MemberData(nameof(Threads))]
    public async Task Stopping_ends_the_wait_and_counts_its_frame(ReceiveThread thread)
    {
        using var stream = new FedStream();
        var reader = new NeuronReader(stream, SourceReaderTests.Options(thread));
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = 2, WhenFull = WhenFull.Wait });
        reader.Start();
        stream.Feed(TestPackets.Motions(0, 5));
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 3 && reader.IsDelivering);

        await reader.DisposeAsync().AsTask().Soon();
        await reader.Completion.Soon();
        await Limits.UntilAsync(() => stream.IsDisposed && !reader.IsDelivering);
        Assert.Equal(reader.GetStatistics().Frames, queue.Dropped + queue.Count);
        Assert.Equal(1, queue.Dropped);
    }

    private static async Task<List<float>> TakeAllAsync(FrameQueue queue)
    {
        List<float> values = [];
        while (await queue.WaitAsync(TestContext.Current.CancellationToken).Soon())
            queue.Pump<MotionFrame>(frame => values.Add(frame.Values[0]));

        return values;
    }
}
