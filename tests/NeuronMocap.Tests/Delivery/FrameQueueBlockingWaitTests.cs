using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class FrameQueueBlockingWaitTests
{
    private readonly FrameQueue _queue = new(16, SkeletonFormat.Default, static _ => { });

    private static CancellationToken Cancelled => TestContext.Current.CancellationToken;

    [Fact]
    public void A_waiting_frame_ends_the_wait_at_once_without_an_allocation()
    {
        Publish(_queue, 1);
        Assert.True(_queue.Wait(Cancelled));
        Allocations.AssertNone(() => _queue.Wait(Cancelled));
    }

    // The second wait, on the thread pool, gets no signal of the first one.
    [Fact]
    public async Task A_frame_ends_each_wait_of_either_kind()
    {
        for (int i = 0; i < 6; i++)
        {
            Task<bool> wait = i % 3 == 1 ? _queue.WaitAsync(Cancelled).AsTask() : WaitOnThreadAsync(_queue);
            Assert.False(wait.IsCompleted);
            Publish(_queue, i);
            Assert.True(await wait.Soon());
            Assert.Equal(1, _queue.Pump<MotionFrame>(static _ => { }));
        }
    }

    [Fact]
    public void The_end_leaves_the_last_frames_to_be_taken()
    {
        Publish(_queue, 1);
        _queue.CompleteAdding();
        Assert.True(_queue.Wait(Cancelled));
        _queue.Pump<MotionFrame>(static _ => { });
        Assert.False(_queue.Wait(Cancelled));
    }

    [Fact]
    public async Task The_end_and_the_disposal_end_a_wait()
    {
        Task<bool> wait = WaitOnThreadAsync(_queue);
        _queue.CompleteAdding();
        Assert.False(await wait.Soon());

        var disposed = new FrameQueue(16, SkeletonFormat.Default, static _ => { });
        wait = WaitOnThreadAsync(disposed);
        disposed.Dispose();
        Assert.False(await wait.Soon());
        Assert.False(disposed.Wait(Cancelled));
    }

    [Fact]
    public async Task A_cancelled_wait_throws_and_the_next_one_gets_the_frame()
    {
        using var cancellation = new CancellationTokenSource();
        Exception? thrown = null;
        var thread = new Thread(() => thrown = Record.Exception(() => _queue.Wait(cancellation.Token))) { IsBackground = true };
        thread.Start();
        await Limits.UntilAsync(() => thread.ThreadState.HasFlag(ThreadState.WaitSleepJoin));
        cancellation.Cancel();
        await Limits.UntilAsync(() => !thread.IsAlive);
        Assert.IsAssignableFrom<OperationCanceledException>(thrown);

        Task<bool> wait = WaitOnThreadAsync(_queue);
        Publish(_queue, 1);
        Assert.True(await wait.Soon());
    }

    [Fact]
    public void A_cancelled_wait_throws_also_while_frames_wait()
    {
        Publish(_queue, 1);
        Assert.ThrowsAny<OperationCanceledException>(() => _queue.Wait(new CancellationToken(canceled: true)));
        Assert.True(_queue.Wait(Cancelled));
    }

    [Fact]
    public async Task It_is_refused_during_another_wait_which_gets_the_frame()
    {
        Task<bool> first = _queue.WaitAsync(Cancelled).AsTask();
        Assert.Throws<InvalidOperationException>(() => _queue.Wait(Cancelled));
        Publish(_queue, 1);
        Assert.True(await first.Soon());
    }

    // Bursts end floods and begin them anew. The consumer takes the last frame of each burst, although no more frames come.
    [Theory]
    [InlineData(WhenFull.DropNewest, 1)]
    [InlineData(WhenFull.DropNewest, 64)]
    [InlineData(WhenFull.DropOldest, 64)]
    public async Task No_frame_is_left_behind_while_floods_begin_and_end(WhenFull whenFull, int capacity)
    {
        const int Bursts = 200, Burst = 200;
        using var queue = new FrameQueue(capacity, SkeletonFormat.Default, static _ => { }, whenFull: whenFull);
        int taken = 0;
        Task consuming = Task.Factory.StartNew(
            () =>
            {
                while (queue.Wait(Cancelled))
                    Volatile.Write(ref taken, taken + queue.Pump<MotionFrame>(static _ => { }));
            },
            Cancelled,
            TaskCreationOptions.LongRunning,
            TaskScheduler.Default);
        for (int burst = 0; burst < Bursts; burst++)
        {
            for (int i = 0; i < Burst; i++)
            {
                Publish(queue, i);
                Thread.SpinWait(burst % 2 * 50);
            }

            await Limits.UntilAsync(() => Volatile.Read(ref taken) + queue.Dropped == (burst + 1) * Burst);
        }

        queue.CompleteAdding();
        await consuming.Soon();
        Assert.Equal(Bursts * Burst, taken + queue.Dropped);
    }

    private static Task<bool> WaitOnThreadAsync(FrameQueue queue) =>
        Task.Factory.StartNew(() => queue.Wait(Cancelled), Cancelled, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    private static void Publish(FrameQueue queue, int index) =>
        ((IPacketConsumer)queue).OnPacket(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(index), 0, 0));
}
