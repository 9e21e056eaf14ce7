using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;

namespace NeuronMocap.Benchmarks.Macro;

// The whole path of a frame without a network, on one thread with a hot cache: scan, count, decode the header, publish, take.
internal static class Decode
{
    private const int Rounds = 2_000_000;

    public static async Task<int> RunAsync(int runs, Report report)
    {
        report.Begin($"Nanoseconds a frame of {TestFrame.Size} bytes that lies in the processor's cache, against copying it once; {Rounds} frames a run, {runs} runs.");
        report.Add(await Alternation.RunAsync("one frame", runs, Floor(Rounds), Ways(Rounds), [new Aim("ns/frame", 5, IsRatio: true), new Aim("B/frame", 0)]));
        return report.End();
    }

    public static Way Floor(int rounds) => new("copy", () => Copy(rounds));

    public static Way[] Ways(int rounds) =>
    [
        new("callback", () => Measure(rounds, static (pipeline, handled) => Callback(pipeline, handled))),
        new("queue", () => Measure(rounds, static (pipeline, handled) => Queue(pipeline, handled))),
        new("newest", () => Measure(rounds, static (pipeline, handled) => Newest(pipeline, handled))),
    ];

    private static Measurements Copy(int rounds)
    {
        byte[] packet = TestFrame.Create();
        byte[] target = new byte[packet.Length];
        TimeSpan cpu = RuntimeFigures.CpuTime;
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < rounds; i++)
            packet.AsSpan().CopyTo(target);

        return new Measurements
        {
            ["ns/frame"] = Stopwatch.GetElapsedTime(start).TotalNanoseconds / rounds,
            [Check.Cpu] = (RuntimeFigures.CpuTime - cpu).TotalNanoseconds / rounds,
        };
    }

    private static Measurements Measure(int rounds, Func<ReceivePipeline, int[], Action> open)
    {
        byte[] packet = TestFrame.Create();
        ReceivePipeline pipeline = Pipelines.Create();
        int[] handled = [0];
        Action take = open(pipeline, handled);
        var assembler = new PacketAssembler(new PacketScanner(), pipeline);
        uint index = 0;
        Push(1000);

        handled[0] = 0;
        long allocated = GC.GetAllocatedBytesForCurrentThread();
        TimeSpan cpu = RuntimeFigures.CpuTime;
        long start = Stopwatch.GetTimestamp();
        Push(rounds);
        double nanoseconds = Stopwatch.GetElapsedTime(start).TotalNanoseconds / rounds;
        cpu = RuntimeFigures.CpuTime - cpu;
        allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
        if (handled[0] != rounds)
            throw new InvalidOperationException($"{handled[0]} of {rounds} frames were delivered.");

        return new Measurements { ["ns/frame"] = nanoseconds, [Check.Cpu] = cpu.TotalNanoseconds / rounds, ["B/frame"] = allocated / (double)rounds };

        void Push(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                TestFrame.SetIndex(packet, ++index);
                assembler.Push(packet, i);
                take();
            }
        }
    }

    private static Action Callback(ReceivePipeline pipeline, int[] handled)
    {
        pipeline.Callbacks.Motion.Add(frame => handled[0] += Math.Sign(frame.Values.Length));
        return static () => { };
    }

    private static Action Queue(ReceivePipeline pipeline, int[] handled)
    {
        FrameQueue queue = pipeline.OpenQueue(8, "queue");
        Action<MotionFrame> handle = frame => handled[0] += Math.Sign(frame.Values.Length);
        return () => queue.Pump(handle);
    }

    private static Action Newest(ReceivePipeline pipeline, int[] handled)
    {
        LatestFrames latest = pipeline.OpenLatest();
        return () =>
        {
            if (latest.TryTakeMotion(0, out MotionFrame? frame))
                handled[0] += Math.Sign(frame.Values.Length);
        };
    }
}
