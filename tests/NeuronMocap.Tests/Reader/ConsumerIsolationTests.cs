using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

/// <summary>Consumers that are slow, throw or hang, on a real connection, with other threads competing for the processors.</summary>
[Collection(nameof(Alone))]
public sealed class ConsumerIsolationTests : IDisposable
{
    private const int Sent = 12_000;
    private const int Count = 180;
    private const int FrameSize = 64 + (4 * Count);

    private static readonly Lazy<byte[]> LazyStream =
        new(() => TestPackets.Join(Enumerable.Range(0, Sent).Select(frame => TestPackets.Motion(frame, count: Count))));

    private readonly TestServer _server = new();
    private readonly ManualResetEventSlim _release = new();

    [Fact]
    public async Task Slow_throwing_and_stuck_consumers_lose_only_their_own_frames()
    {
        await using var reader = new NeuronReader(_server.Options());
        var called = new RunOfFrames();
        int thrown = 0;
        reader.MotionReceived += frame => thrown += frame.FrameIndex % 4 == 0 ? throw new FormatException() : 0;
        reader.MotionReceived += called.Add;

        using FrameQueue steady = reader.OpenQueue(Sent);
        using FrameQueue slow = reader.OpenQueue(16);
        using FrameQueue throwing = reader.OpenQueue(64);
        using FrameQueue stuck = reader.OpenQueue(8);
        using LatestFrames held = reader.OpenLatest();
        Task<RunOfFrames> pumpedSteadily = PumpAsync(steady, reader, static () => { });
        Task<RunOfFrames> pumpedSlowly = PumpAsync(slow, reader, static () => Thread.Sleep(1));
        Task<RunOfFrames> pumpedThrowing = PumpAsync(throwing, reader, static () => throw new FormatException());
        Task<RunOfFrames> pumpedStuck = PumpAsync(stuck, reader, _release.Wait);
        Task<int> holding = HoldAsync(held);
        await using IAsyncEnumerator<MotionFrame> enumeration = reader.ReadMotionAsync().GetAsyncEnumerator();
        Task<bool> enumerated = enumeration.MoveNextAsync().AsTask();

        using (new Preemption())
        {
            using TestConnection connection = await _server.AcceptAsync();
            await connection.SendPiecesAsync(LazyStream.Value, 50_000);
            connection.Close();
            await reader.Completion.Soon();
        }

        // All frames were received while two consumers hung and a third did not return for its second frame.
        Assert.False(pumpedStuck.IsCompleted || holding.IsCompleted);
        Assert.Equal(Sent, reader.GetStatistics().MotionFrames);
        Assert.Equal((Sent, 0), (called.Frames, called.Missing));
        Assert.Equal(Sent / 4, reader.GetStatistics().CallbackFailures);
        _release.Set();

        Assert.Equal((Sent, 0L), ((await pumpedSteadily.Soon()).Frames, steady.Dropped));
        foreach ((FrameQueue queue, Task<RunOfFrames> pumped) in ((FrameQueue, Task<RunOfFrames>)[])
            [(slow, pumpedSlowly), (throwing, pumpedThrowing), (stuck, pumpedStuck)])
        {
            Assert.Equal(Sent, (await pumped.Soon()).Frames + queue.Dropped);
        }

        Assert.Equal(Sent - 8, stuck.Dropped);
        Assert.Equal(Sent - 1, await holding.Soon());
        int fromEnumeration = 0;
        for (bool isThere = await enumerated.Soon(); isThere; isThere = await enumeration.MoveNextAsync().AsTask().Soon())
            fromEnumeration++;

        long dropped = slow.Dropped + throwing.Dropped + stuck.Dropped + (Sent - fromEnumeration);
        Assert.Equal(dropped, reader.GetStatistics().Dropped);
    }

    // Each visitor leaves and the next one arrives in the middle of the frames that the first one requested.
    [Fact]
    public async Task Temporary_queues_see_no_gaps()
    {
        const int visits = 40;
        const int portion = Sent / visits;
        await using var reader = new NeuronReader(_server.Options());
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        using var asked = new SemaphoreSlim(0);
        using (new Preemption())
        {
            Task visiting = Task.Run(() =>
            {
                for (int visit = 0; visit < visits; visit++)
                {
                    using FrameQueue queue = reader.OpenQueue(2 * portion);
                    asked.Release();
                    var seen = new RunOfFrames();
                    while (seen.Frames < portion / 6 && !reader.Completion.IsCompleted)
                        queue.Pump<MotionFrame>(seen.Add);

                    Assert.Equal((0, 0L), (seen.Missing, queue.Dropped));
                }
            });
            for (int start = 0; start < LazyStream.Value.Length; start += portion * FrameSize)
            {
                await asked.WaitAsync(TestContext.Current.CancellationToken).Soon();

                // The visitor's queue has room for the portion that was in transit when it was opened, and for this one.
                int earlier = start / FrameSize;
                await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames >= earlier);
                await connection.SendAsync(LazyStream.Value.AsMemory(start, portion * FrameSize));
            }

            connection.Close();
            await visiting.Soon();
            await reader.Completion.Soon();
        }

        Assert.Equal(Sent, reader.GetStatistics().MotionFrames);
    }

    public void Dispose()
    {
        _release.Set();
        _server.Dispose();
    }

    // Pumps on its own thread until the reader has ended and the queue is empty. Checks the frame before and after the handler runs.
    private static Task<RunOfFrames> PumpAsync(FrameQueue queue, NeuronReader reader, Action dawdle) => Task.Factory.StartNew(
        () =>
        {
            var seen = new RunOfFrames();
            while (true)
            {
                bool ended = reader.Completion.IsCompleted;
                try
                {
                    if (queue.Pump<MotionFrame>(Handle, maxFrames: 1) == 0 && ended)
                        return seen;
                    if (queue.Count == 0)
                        Thread.Yield();
                }
                catch (FormatException)
                {
                    // The handler's own exception. The next call continues after it.
                }
            }

            void Handle(MotionFrame frame)
            {
                seen.Add(frame);
                dawdle();
                RunOfFrames.Check(frame);
            }
        },
        CancellationToken.None,
        TaskCreationOptions.LongRunning,
        TaskScheduler.Default);

    // Takes the first frame and checks it until released. Then returns the number of the newest frame.
    private Task<int> HoldAsync(LatestFrames latest) => Task.Factory.StartNew(
        () =>
        {
            MotionFrame? frame;
            while (!latest.TryTakeMotion(0, out frame))
                Thread.Yield();

            uint? first = frame.FrameIndex;
            while (!_release.Wait(millisecondsTimeout: 1))
                RunOfFrames.Check(frame);

            Assert.Equal(first, frame.FrameIndex);
            Assert.True(latest.TryTakeMotion(0, out frame));
            RunOfFrames.Check(frame);
            return (int)frame.FrameIndex!.Value;
        },
        CancellationToken.None,
        TaskCreationOptions.LongRunning,
        TaskScheduler.Default);

    // Counts frames that are whole and in order.
    private sealed class RunOfFrames
    {
        private int _next = -1;

        public int Frames { get; private set; }

        public int Missing { get; private set; }

        public static void Check(MotionFrame frame)
        {
            int number = (int)frame.FrameIndex!.Value;
            Assert.Equal(Count, frame.Values.Length);
            for (int value = 0; value < Count; value++)
            {
                if (frame.Values[value] != TestPackets.Value(number, 0, value))
                    Assert.Fail($"Value {value} of frame {number} is {frame.Values[value]}: another frame's.");
            }
        }

        public void Add(MotionFrame frame)
        {
            int number = (int)frame.FrameIndex!.Value;
            Check(frame);
            if (_next >= 0)
            {
                Assert.True(number >= _next, $"{number} after {_next - 1}");
                Missing += number - _next;
            }

            _next = number + 1;
            Frames++;
        }
    }
}
