using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Recording;

namespace NeuronMocap.Benchmarks.Macro;

// The cost of a recording for the receive thread: frames to a callback, with and without a recording, on a hot cache. The frames of a batch fit into
// the recording's queue, and the next batch follows when they are written. They are written to a null stream, because the disk is not measured.
internal static class Record
{
    private const int Batch = 2_000;
    private const int Batches = 200;

    public static async Task<int> RunAsync(int runs, Report report)
    {
        report.Begin($"Nanoseconds of the receive thread a frame of {TestFrame.Size} bytes, against the same without a recording; {Batch * Batches} frames a run, {runs} runs.");
        Way[] ways =
        [
            new("recorded", static () => Measure(Batches, recordings: 1)),
            new("recorded twice", static () => Measure(Batches, recordings: 2)),
        ];
        Aim[] aims = [new Aim("ns/frame", 1.5, IsRatio: true, Way: "recorded"), new Aim("ns/frame", 2, IsRatio: true, Way: "recorded twice"), new Aim("B/frame", 0)];
        report.Add(await Alternation.RunAsync("one frame", runs, new Way("not recorded", static () => Measure(Batches, recordings: 0)), ways, aims));
        return report.End();
    }

    public static Figures Measure(int batches, int recordings)
    {
        byte[] packet = TestFrame.Create();
        ReceivePipeline pipeline = Pipelines.Create();
        int handled = 0;
        pipeline.Callbacks.Motion.Add(frame => handled += Math.Sign(frame.Values.Length));
        pipeline.Tap.Open(isDatagrams: false, local: null, remote: null, Stopwatch.GetTimestamp());
        StreamRecorder[] recorders = [.. Enumerable.Range(0, recordings).Select(_ => Start(pipeline.Tap))];
        var assembler = new PacketAssembler(new PacketScanner(), pipeline);
        uint index = 0;
        Push();

        long allocated = 0;
        long elapsed = 0;
        TimeSpan cpu = RuntimeFigures.CpuTime;
        for (int i = 0; i < batches; i++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            long start = Stopwatch.GetTimestamp();
            Push();
            elapsed += Stopwatch.GetTimestamp() - start;
            allocated += GC.GetAllocatedBytesForCurrentThread() - before;
            WaitUntilWritten();
        }

        cpu = RuntimeFigures.CpuTime - cpu;
        foreach (StreamRecorder recorder in recorders)
            recorder.Dispose();
        if (handled != Batch * (batches + 1) || recorders.Any(recorder => recorder.GetStatistics().Pieces != Batch * (batches + 1)))
            throw new InvalidOperationException("Not every frame was delivered and recorded.");

        return new Figures
        {
            ["ns/frame"] = elapsed * 1e9 / Stopwatch.Frequency / (Batch * batches),
            [Check.Cpu] = cpu.TotalNanoseconds / (Batch * batches),
            ["B/frame"] = allocated / (double)(Batch * batches),
        };

        void WaitUntilWritten()
        {
            while (!Array.TrueForAll(recorders, static recorder => recorder.GetStatistics() is var done && done.WrittenBytes >= done.Bytes))
                Thread.Sleep(1);
        }

        void Push()
        {
            for (int i = 0; i < Batch; i++)
            {
                TestFrame.SetIndex(packet, ++index);
                assembler.Push(packet, Stopwatch.GetTimestamp());
            }
        }
    }

    private static StreamRecorder Start(StreamTap tap) => new(
        "nowhere.nmrec", new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) }, RecordingMetadata.Empty, tap, static _ => { }, static (_, _) => Stream.Null);
}
