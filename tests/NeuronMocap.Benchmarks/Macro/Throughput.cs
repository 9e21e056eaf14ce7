using System.Diagnostics;
using System.Net.Sockets;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// One TCP sender in its own process and one receiver: a raw socket that parses nothing, then each way of delivery in turn.
internal static class Throughput
{
    private const string Rate = "frames/s";
    private const string Cpu = "CPU ns/frame";

    // Room for the frames that arrive while the consumer's thread wakes up.
    private const int QueueCapacity = 4 * 1024;

    private static readonly Aim[] Aims =
    [
        new(Rate, 0.95, IsRatio: true, IsLowerBound: true, Way: "callback"),
        new(Rate, 0.85, IsRatio: true, IsLowerBound: true, Way: "queue"),
        new(Rate, 0.9, IsRatio: true, IsLowerBound: true, Way: "newest"),
        new("lost", 0),
        new("B/frame", 0.01, Way: "callback"),
    ];

    public static async Task<int> RunAsync(int frames, int runs, int[] writes, Report report)
    {
        report.Begin($"{frames} frames of {TestFrame.Size} bytes over loopback TCP, {runs} runs; the floor is a blocking receive into {RawReceiver.BufferSize / 1024} KiB.");
        foreach (int perWrite in writes)
        {
            Way[] ways =
            [
                new("callback", () => CallbackAsync(perWrite, frames)),
                new("queue", () => QueueAsync(perWrite, frames, TakeOnThreadAsync)),
                new("queue, WaitAsync", () => QueueAsync(perWrite, frames, TakeOnPoolAsync)),
                new("newest", () => NewestAsync(perWrite, frames)),
            ];
            report.Add(await Alternation.RunAsync($"{perWrite} frames/write", runs, new Way("raw", () => FloorAsync(perWrite, frames)), ways, Aims));
        }

        return report.End();
    }

    private static Task<Peer> StartSenderAsync(int perWrite, int frames) =>
        Peer.StartAsync("flood", "--per-write", Peer.Text(perWrite), "--frames", Peer.Text(frames));

    public static async Task<Measurements> FloorAsync(int perWrite, int frames)
    {
        using Peer sender = await StartSenderAsync(perWrite, frames);
        using Socket socket = RawReceiver.Connect(sender.Port);
        byte[] buffer = new byte[RawReceiver.BufferSize];
        long received = socket.Receive(buffer);
        long start = Stopwatch.GetTimestamp();
        TimeSpan cpu = RuntimeFigures.CpuTime;
        for (int count = 1; count > 0; received += count)
            count = socket.Receive(buffer);

        double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        return new Measurements
        {
            [Rate] = received / (double)TestFrame.Size / seconds,
            [Cpu] = (RuntimeFigures.CpuTime - cpu).TotalMilliseconds * 1e6 / frames,
        };
    }

    public static async Task<Measurements> CallbackAsync(int perWrite, int frames)
    {
        using Peer sender = await StartSenderAsync(perWrite, frames);
        await using NeuronReader reader = CreateReader(sender);
        long counted = 0;
        long? allocatedBefore = null;
        long? allocated = null;
        reader.MotionReceived += _ =>
        {
            // Measured from the middle to the last frame. Connecting and ending allocate, and the receive buffer grows once, when the reader falls behind.
            if (++counted == frames / 2)
                allocatedBefore = RuntimeFigures.AllocatedBytes;
            if (counted == frames)
                allocated = RuntimeFigures.AllocatedBytes - allocatedBefore;
        };
        TimeSpan cpu = RuntimeFigures.CpuTime;
        reader.Start();
        await reader.Completion;
        return ToFigures(reader, cpu, frames, counted, allocated / (frames / 2.0));
    }

    public static async Task<Measurements> QueueAsync(int perWrite, int frames, Func<FrameQueue, Task<long>> takeAsync)
    {
        using Peer sender = await StartSenderAsync(perWrite, frames);
        await using NeuronReader reader = CreateReader(sender);
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = QueueCapacity, WhenFull = WhenFull.Wait });
        TimeSpan cpu = RuntimeFigures.CpuTime;
        reader.Start();
        long counted = await takeAsync(queue);
        await reader.Completion;
        return ToFigures(reader, cpu, frames, counted);
    }

    private static Task<long> TakeOnThreadAsync(FrameQueue queue) => Task.Factory.StartNew(
        () =>
        {
            long counted = 0;
            while (queue.Wait())
                counted += queue.Pump<MotionFrame>(static _ => { });

            return counted;
        },
        CancellationToken.None,
        TaskCreationOptions.LongRunning,
        TaskScheduler.Default);

    private static async Task<long> TakeOnPoolAsync(FrameQueue queue)
    {
        long counted = 0;
        while (await queue.WaitAsync())
            counted += queue.Pump<MotionFrame>(static _ => { });

        return counted;
    }

    // Newer frames replace older ones by design, so only frames that were not received count as lost.
    private static async Task<Measurements> NewestAsync(int perWrite, int frames)
    {
        using Peer sender = await StartSenderAsync(perWrite, frames);
        await using NeuronReader reader = CreateReader(sender);
        using LatestFrames latest = reader.OpenLatest();
        TimeSpan cpu = RuntimeFigures.CpuTime;
        reader.Start();
        while (!reader.Completion.IsCompleted)
        {
            latest.TryTakeMotion(0, out _);
            Thread.Sleep(1);
        }

        return ToFigures(reader, cpu, frames, reader.GetStatistics().MotionFrames);
    }

    private static NeuronReader CreateReader(Peer sender) => new(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });

    private static Measurements ToFigures(NeuronReader reader, TimeSpan cpuBefore, int sent, long delivered, double? allocated = null)
    {
        TimeSpan cpu = RuntimeFigures.CpuTime - cpuBefore;
        ReaderStatistics statistics = reader.GetStatistics();
        var figures = new Measurements
        {
            [Rate] = statistics.MotionFrames / statistics.Duration.TotalSeconds,
            [Cpu] = cpu.TotalMilliseconds * 1e6 / sent,
            ["lost"] = sent - delivered,
        };
        if (allocated is { } bytes)
            figures["B/frame"] = bytes;

        return figures;
    }
}
