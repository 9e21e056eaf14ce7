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
        Way[] ways =
        [
            new("callback", () => Measure(static (pipeline, handled) => Callback(pipeline, handled))),
            new("queue", () => Measure(static (pipeline, handled) => Queue(pipeline, handled))),
            new("newest", () => Measure(static (pipeline, handled) => Newest(pipeline, handled))),
        ];
        report.Add(await Alternation.RunAsync("one frame", runs, new Way("copy", Copy), ways, [new Aim("ns/frame", 4, IsRatio: true), new Aim("B/frame", 0)]));
        return report.End();
    }

    private static Figures Copy()
    {
        byte[] packet = TestFrame.Create();
        byte[] target = new byte[packet.Length];
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < Rounds; i++)
            packet.AsSpan().CopyTo(target);

        return new Figures { ["ns/frame"] = Stopwatch.GetElapsedTime(start).TotalNanoseconds / Rounds };
    }

    private static Figures Measure(Func<ReceivePipeline, int[], Action> open)
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
        long start = Stopwatch.GetTimestamp();
        Push(Rounds);
        double nanoseconds = Stopwatch.GetElapsedTime(start).TotalNanoseconds / Rounds;
        allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
        if (handled[0] != Rounds)
            throw new InvalidOperationException($"{handled[0]} of {Rounds} frames were delivered.");

        return new Figures { ["ns/frame"] = nanoseconds, ["B/frame"] = allocated / (double)Rounds };

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
