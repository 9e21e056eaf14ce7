using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;

namespace NeuronMocap.Benchmarks.Macro;

// The cost of more avatars in one stream, and of more consumers, on one thread without a network. The floor is one of each.
internal static class Scaling
{
    private const int Frames = 400_000;
    private const int PerPiece = 40;

    public static async Task<int> AvatarsAsync(int[] counts, int runs, Report report)
    {
        report.Begin($"Nanoseconds a frame to scan, count, queue and take it, with several avatars in one stream; {Frames} frames a run, {runs} runs; the floor is one avatar.");
        foreach (int count in counts)
        {
            Way floor = new("1 avatar", () => Measure(1, 1, newest: false));
            Way[] ways = [new("queue", () => Measure(count, 1, newest: false)), new("newest", () => Measure(count, 1, newest: true))];
            report.Add(await Alternation.RunAsync($"{count} avatars", runs, floor, ways, [new Aim("ns/frame", 1, IsRatio: true, Way: "queue")]));
        }

        return report.End();
    }

    public static async Task<int> ConsumersAsync(int[] counts, int runs, Report report)
    {
        report.Begin($"Nanoseconds a frame and consumer; {Frames} frames a run, {runs} runs; the floor is one consumer.");
        foreach (int count in counts)
        {
            foreach (bool newest in new[] { false, true })
            {
                Way floor = new("1 consumer", () => Measure(1, 1, newest));
                Way way = new(newest ? "newest" : "queue", () => Measure(1, count, newest));
                report.Add(await Alternation.RunAsync($"{count} consumers", runs, floor, [way], [new Aim("ns/frame", 1, IsRatio: true)]));
            }
        }

        return report.End();
    }

    public static Measurements Measure(int avatars, int consumers, bool newest, int frames = Frames)
    {
        ReceivePipeline pipeline = Pipelines.Create();
        FrameQueue[] queues = [.. Enumerable.Range(0, newest ? 0 : consumers).Select(_ => pipeline.OpenQueue(2 * PerPiece, "queue"))];
        LatestFrames[] latest = [.. Enumerable.Range(0, newest ? consumers : 0).Select(_ => pipeline.OpenLatest())];
        var assembler = new PacketAssembler(new PacketScanner(), pipeline);
        byte[] piece = new byte[PerPiece * TestFrame.Size];
        byte[][] packets = [.. Enumerable.Range(0, avatars).Select(TestFrame.Create)];
        long taken = 0;
        Action<NeuronMocap.MotionFrame> take = _ => taken++;
        Run(frames / 10);
        taken = 0;
        TimeSpan cpu = RuntimeFigures.CpuTime;
        long start = Stopwatch.GetTimestamp();
        Run(frames);
        double nanoseconds = Stopwatch.GetElapsedTime(start).TotalNanoseconds;
        cpu = RuntimeFigures.CpuTime - cpu;
        if (!newest && taken != (long)frames * consumers)
            throw new InvalidOperationException($"{taken} of {(long)frames * consumers} frames were taken.");

        return new Measurements { ["ns/frame"] = nanoseconds / frames / consumers, [Check.Cpu] = cpu.TotalNanoseconds / frames / consumers };

        void Run(int count)
        {
            uint index = 0;
            int avatar = 0;
            for (int done = 0; done < count; done += PerPiece)
            {
                for (int i = 0; i < PerPiece; i++)
                {
                    Span<byte> packet = piece.AsSpan(i * TestFrame.Size, TestFrame.Size);
                    packets[avatar].AsSpan(0, TestFrame.HeaderSize).CopyTo(packet);
                    TestFrame.SetIndex(packet, index);
                    if (++avatar == avatars)
                    {
                        avatar = 0;
                        index++;
                    }
                }

                assembler.Push(piece, done);
                foreach (FrameQueue queue in queues)
                    queue.Pump(take);
                foreach (LatestFrames view in latest)
                {
                    for (int i = 0; i < avatars; i++)
                        view.TryTakeMotion(i, out _);
                }
            }
        }
    }
}
