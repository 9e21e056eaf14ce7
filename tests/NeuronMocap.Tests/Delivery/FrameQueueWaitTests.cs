using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class FrameQueueWaitTests
{
    private readonly FrameQueue _queue = new(16, SkeletonFormat.Default, static _ => { });

    private static CancellationToken Cancelled => TestContext.Current.CancellationToken;

    [Fact]
    public async Task A_waiting_frame_ends_the_wait_at_once_without_an_allocation()
    {
        Publish(1);
        Assert.True(await _queue.WaitAsync(Cancelled));
        long before = GC.GetAllocatedBytesForCurrentThread();
        bool isWaiting = await _queue.WaitAsync(Cancelled);
        Assert.Equal(before, GC.GetAllocatedBytesForCurrentThread());
        Assert.True(isWaiting);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public async Task A_frame_ends_each_wait(int waits)
    {
        for (int i = 0; i < waits; i++)
        {
            Task<bool> wait = _queue.WaitAsync(Cancelled).AsTask();
            Assert.False(wait.IsCompleted);
            Publish(i);
            Assert.True(await wait.Soon());
            Assert.Equal(1, _queue.Pump<MotionFrame>(static _ => { }));
        }
    }

    [Fact]
    public async Task The_end_leaves_the_last_frames_to_be_taken()
    {
        Publish(1);
        _queue.CompleteAdding();
        Assert.True(await _queue.WaitAsync(Cancelled));
        _queue.Pump<MotionFrame>(static _ => { });
        Assert.False(await _queue.WaitAsync(Cancelled));
    }

    [Fact]
    public async Task The_end_and_the_disposal_end_a_wait()
    {
        Task<bool> wait = _queue.WaitAsync(Cancelled).AsTask();
        _queue.CompleteAdding();
        Assert.False(await wait.Soon());

        var disposed = new FrameQueue(16, SkeletonFormat.Default, static _ => { });
        wait = disposed.WaitAsync(Cancelled).AsTask();
        disposed.Dispose();
        Assert.False(await wait.Soon());
        Assert.False(await disposed.WaitAsync(Cancelled));
    }

    [Fact]
    public async Task A_cancelled_wait_throws_and_the_next_one_gets_the_frame()
    {
        using var cancellation = new CancellationTokenSource();
        Task<bool> wait = _queue.WaitAsync(cancellation.Token).AsTask();
        cancellation.Cancel();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => wait.Soon());

        wait = _queue.WaitAsync(Cancelled).AsTask();
        Publish(1);
        Assert.True(await wait.Soon());
    }

    [Fact]
    public async Task A_cancelled_wait_throws_also_while_frames_wait()
    {
        Publish(1);
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => _queue.WaitAsync(new CancellationToken(canceled: true)).AsTask().Soon());
        Assert.True(await _queue.WaitAsync(Cancelled));
    }

    [Fact]
    public async Task A_second_wait_is_refused_and_the_first_one_gets_the_frame()
    {
        Task<bool> first = _queue.WaitAsync(Cancelled).AsTask();
        await Assert.ThrowsAsync<InvalidOperationException>(() => _queue.WaitAsync(Cancelled).AsTask().Soon());
        Assert.False(first.IsCompleted);
        Publish(1);
        Assert.True(await first.Soon());

        _queue.Pump<MotionFrame>(static _ => { });
        Task<bool> next = _queue.WaitAsync(Cancelled).AsTask();
        _queue.Dispose();
        Assert.False(await next.Soon());
    }

    [Theory]
    [InlineData(WhenFull.DropNewest)]
    [InlineData(WhenFull.DropOldest)]
    public async Task No_frame_is_left_behind_while_both_sides_race(WhenFull whenFull)
    {
        const int Frames = 20_000;
        using var queue = new FrameQueue(32, SkeletonFormat.Default, static _ => { }, whenFull: whenFull);
        Task producing = Task.Run(
            () =>
            {
                byte[] packet = TestPackets.Motion(0);
                for (int i = 0; i < Frames; i++)
                {
                    ((IPacketConsumer)queue).OnPacket(new ReceivedPacket(PacketKind.Motion, packet, 0, 0));
                    Thread.SpinWait(i % 64);
                }

                queue.CompleteAdding();
            },
            Cancelled);

        int taken = 0;
        while (await queue.WaitAsync(Cancelled).AsTask().Soon())
            taken += queue.Pump<MotionFrame>(static _ => { });

        await producing;
        Assert.Equal(Frames, taken + queue.Dropped);
    }

    // Bursts end floods and begin them anew, on both sides of their limits.
    [Theory]
    [InlineData(WhenFull.DropNewest, 1)]
    [InlineData(WhenFull.DropNewest, 64)]
    [InlineData(WhenFull.DropOldest, 64)]
    public async Task No_frame_is_left_behind_while_floods_begin_and_end(WhenFull whenFull, int capacity)
    {
        const int Bursts = 200, Burst = 200;
        using var queue = new FrameQueue(capacity, SkeletonFormat.Default, static _ => { }, whenFull: whenFull);
        int taken = 0;
        Task producing = Task.Run(
            async () =>
            {
                byte[] packet = TestPackets.Motion(0);
                for (int burst = 0; burst < Bursts; burst++)
                {
                    for (int i = 0; i < Burst; i++)
                    {
                        ((IPacketConsumer)queue).OnPacket(new ReceivedPacket(PacketKind.Motion, packet, 0, 0));
                        Thread.SpinWait(burst % 2 * 50);
                    }

                    // The consumer takes the last frame of each burst, although no more frames come.
                    await Limits.UntilAsync(() => Volatile.Read(ref taken) + queue.Dropped == (burst + 1) * Burst);
                }

                queue.CompleteAdding();
            },
            Cancelled);

        while (await queue.WaitAsync(Cancelled).AsTask().Soon())
            Volatile.Write(ref taken, taken + queue.Pump<MotionFrame>(static _ => { }));

        await producing;
        Assert.Equal(Bursts * Burst, taken + queue.Dropped);
    }

    // On the clock of the test, no time passes until a second passes at once.
    [Fact]
    public async Task A_flood_signals_once_for_each_part_of_the_queue()
    {
        const int BeginsWith = 31, EndsWith = 35, Frames = 40;
        using var queue = new FrameQueue(64, SkeletonFormat.Default, static _ => { });
        long now = 1;
        queue.PrepareWaiting(() => now);
        var age = Stopwatch.StartNew();
        await Limits.UntilAsync(() => age.ElapsedMilliseconds > 1); // Then a wait does not look again by itself.
        var signals = new SignalCount(queue);

        for (int i = 0; i < Frames; i++)
        {
            if (i == EndsWith)
                now += Stopwatch.Frequency;

            await PassAsync(queue, i);
        }

        Assert.Equal(Frames - (EndsWith - BeginsWith), signals.Value);
    }

    // The first count begins when the computer started. Days in ticks, times the rate of a flood, do not fit into 64 bits.
    [Fact]
    public async Task A_slow_stream_is_no_flood_on_a_computer_that_runs_for_days()
    {
        const int Frames = 40;
        using var queue = new FrameQueue(64, SkeletonFormat.Default, static _ => { });
        long now = 10 * 24 * 3600 * Stopwatch.Frequency;
        queue.PrepareWaiting(() => now += Stopwatch.Frequency);
        var signals = new SignalCount(queue);

        for (int i = 0; i < Frames; i++)
            await PassAsync(queue, i);

        Assert.Equal(Frames, signals.Value);
    }

    // A wait begins, a frame ends it, and the frame is taken.
    private static async Task PassAsync(FrameQueue queue, int index)
    {
        Task<bool> wait = queue.WaitAsync(Cancelled).AsTask();
        Publish(queue, index);
        Assert.True(await wait.Soon());
        queue.Pump<MotionFrame>(static _ => { });
    }

    private void Publish(int index) => Publish(_queue, index);

    private static void Publish(FrameQueue queue, int index) =>
        ((IPacketConsumer)queue).OnPacket(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(index), 0, 0));

    // Counts the signals to the waiting consumer, which still gets them.
    private sealed class SignalCount
    {
        public SignalCount(FrameQueue queue)
        {
            Action set = queue.Changed!;
            queue.Changed = () =>
            {
                Value++;
                set();
            };
        }

        public int Value { get; private set; }
    }
}
