using System.IO.Pipelines;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

/// <summary>A queue that waits for room holds up the writer of a pipe.</summary>
public sealed class PipeBackPressureTests
{
    [Fact]
    public async Task The_writer_waits_for_the_queue_and_nothing_is_lost()
    {
        const int Frames = 50;
        var pipe = new Pipe(new PipeOptions(pauseWriterThreshold: 20_000, resumeWriterThreshold: 10_000));
        await using var reader = new NeuronReader(pipe.Reader, SourceReaderTests.Options());
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = 2, WhenFull = WhenFull.Wait });
        reader.Start();
        Task writing = pipe.Writer.WriteAsync(TestPackets.Motions(0, Frames), TestContext.Current.CancellationToken).AsTask();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 3 && reader.IsDelivering);
        Assert.False(writing.IsCompleted);

        int next = 0;
        while (next < Frames && await queue.WaitAsync(TestContext.Current.CancellationToken).Soon())
            queue.Pump<MotionFrame>(frame => Assert.Equal(next++, frame.Values[0]));

        await writing.Soon();
        await pipe.Writer.CompleteAsync();
        await reader.Completion.Soon();
        Assert.Equal((Frames, 0), (queue.Delivered, queue.Dropped));
    }
}
