using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class FrameQueueBlockingWaitTests
{
    private static readonly byte[] Packet = TestPackets.Motion(0);

    private readonly FrameQueue _queue = new(16, SkeletonFormat.Default, static _ => { });
    private readonly Stopwatch _age = Stopwatch.StartNew();

    public FrameQueueBlockingWaitTests() => _queue.PrepareWaiting();

    private static CancellationToken Cancelled => TestContext.Current.CancellationToken;

    [Fact]
    public void A_waiting_frame_ends_the_wait_at_once_without_an_allocation()
    {
        Publish(_queue);
        Assert.True(_queue.Wait(Cancelled));
        Allocations.AssertNone(() => _queue.Wait(Cancelled));
    }

    [Fact]
    public async Task A_frame_ends_each_wait_of_either_kind()
    {
        for (int i = 0; i < 6; i++)
        {
            Task<bool> wait = i % 3 == 1 ? _queue.WaitAsync(Cancelled).AsTask() : await BlockAsync(Cancelled);
            Publish(_queue);
            Assert.True(await wait.Soon());
            Assert.Equal(1, _queue.Pump<MotionFrame>(static _ => { }));
        }
    }

    [Fact]
    public void The_end_leaves_the_last_frames_to_be_taken()
    {
        Publish(_queue);
        _queue.CompleteAdding();
        Assert.True(_queue.Wait(Cancelled));
        _queue.Pump<MotionFrame>(static _ => { });
        Assert.False(_queue.Wait(Cancelled));
    }

    [Fact]
    public async Task The_end_ends_a_wait()
    {
        Task<bool> wait = await BlockAsync(Cancelled);
        _queue.CompleteAdding();
        Assert.False(await wait.Soon());
    }

    [Fact]
    public async Task The_disposal_ends_a_wait()
    {
        Task<bool> wait = await BlockAsync(Cancelled);
        _queue.Dispose();
        Assert.False(await wait.Soon());
        Assert.False(_queue.Wait(Cancelled));
    }

    [Fact]
    public async Task A_cancelled_wait_throws_and_the_next_one_gets_the_frame()
    {
        using var cancellation = new CancellationTokenSource();
        Task<bool> wait = await BlockAsync(cancellation.Token);
        cancellation.Cancel();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => wait.Soon());

        wait = await BlockAsync(Cancelled);
        Publish(_queue);
        Assert.True(await wait.Soon());
    }

    [Fact]
    public void A_cancelled_wait_throws_also_while_frames_wait()
    {
        Publish(_queue);
        Assert.ThrowsAny<OperationCanceledException>(() => _queue.Wait(new CancellationToken(canceled: true)));
        Assert.True(_queue.Wait(Cancelled));
    }

    [Fact]
    public async Task It_is_refused_during_another_wait_which_gets_the_frame()
    {
        Task<bool> first = _queue.WaitAsync(Cancelled).AsTask();
        Assert.Throws<InvalidOperationException>(() => _queue.Wait(Cancelled));
        Publish(_queue);
        Assert.True(await first.Soon());
    }

    // The consumer takes the last frame of each burst, although no more frames come. On the clock of the test, each 32nd wait begins a flood of a few waits.
    [Theory]
    [InlineData(WhenFull.DropNewest, 1, false)]
    [InlineData(WhenFull.DropNewest, 64, false)]
    [InlineData(WhenFull.DropNewest, 64, true)]
    [InlineData(WhenFull.DropOldest, 64, true)]
    public async Task No_frame_is_left_behind_while_floods_begin_and_end(WhenFull whenFull, int capacity, bool isFlood)
    {
        const int Bursts = 200, Burst = 200;
        using var queue = new FrameQueue(capacity, SkeletonFormat.Default, static _ => { }, whenFull: whenFull);
        if (isFlood)
        {
            long looks = 0;
            queue.PrepareWaiting(() => ++looks / 8 * Stopwatch.Frequency);
        }

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
                Publish(queue);
                Thread.SpinWait(burst % 2 * 50);
            }

            await Limits.UntilAsync(() => Volatile.Read(ref taken) + queue.Dropped == (burst + 1) * Burst);
        }

        queue.CompleteAdding();
        await consuming.Soon();
        Assert.Equal(Bursts * Burst, taken + queue.Dropped);
    }

    // Returns the wait of another thread when that thread has blocked. In the first millisecond, it would look again by itself.
    private async Task<Task<bool>> BlockAsync(CancellationToken cancellationToken)
    {
        await Limits.UntilAsync(() => _age.ElapsedMilliseconds > 1);
        var result = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        var thread = new Thread(() =>
        {
            try
            {
                result.SetResult(_queue.Wait(cancellationToken));
            }
            catch (Exception exception)
            {
                result.SetException(exception);
            }
        })
        {
            IsBackground = true,
        };
        thread.Start();
        await Limits.UntilAsync(() => thread.ThreadState.HasFlag(System.Threading.ThreadState.WaitSleepJoin));
        return result.Task;
    }

    private static void Publish(FrameQueue queue) => ((IPacketConsumer)queue).OnPacket(new ReceivedPacket(PacketKind.Motion, Packet, 0, 0));
}
