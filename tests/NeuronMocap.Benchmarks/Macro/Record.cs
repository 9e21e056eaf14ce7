using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Recording;

namespace NeuronMocap.Benchmarks.Macro;

// The processor time that a recording costs the receive thread: frames to a callback, with and without a recording.
//
// The first case has no network and a hot cache. The frames of a batch fit into the recording's queue, and the next batch follows when they are written to a null
// stream. The bare copy shows what handing the frames to another processor costs. The second case writes files from TCP, at 32,000 frames/s, as many as 530 performers send at 60 Hz.
internal static class Record
{
    private const int Batch = 2_000;
    private const int Batches = 200;
    private const int FramesOverTcp = 64_000;
    private const int FramesPerWrite = 32;

    public static async Task<int> RunAsync(int runs, Report report)
    {
        report.Begin($"Nanoseconds of the receive thread a frame of {TestFrame.Size} bytes, against the same without a recording; {Batch * Batches} frames a run, {FramesOverTcp} over TCP, {runs} runs.");
        Way[] ways =
        [
            new("recorded", static () => Measure(recordings: 1)),
            new("recorded twice", static () => Measure(recordings: 2)),
            new("bare copy", static () => Measure(recordings: 0, isCopied: true)),
        ];
        Way[] waysOverTcp =
        [
            new("recorded", static () => MeasureOverTcpAsync(recordings: 1)),
            new("recorded twice", static () => MeasureOverTcpAsync(recordings: 2)),
        ];
        Aim[] aims = [new Aim("ns/frame", 1.5, IsRatio: true, Way: "recorded"), new Aim("ns/frame", 2, IsRatio: true, Way: "recorded twice"), new Aim("B/frame", 0)];
        report.Add(await Alternation.RunAsync("one frame", runs, new Way("not recorded", static () => Measure(recordings: 0)), ways, aims));
        // The clock of a thread is that of Linux.
        if (OperatingSystem.IsLinux())
            report.Add(await Alternation.RunAsync("TCP", runs, new Way("not recorded", static () => MeasureOverTcpAsync(recordings: 0)), waysOverTcp, aims));
        return report.End();
    }

    // isCopied: another thread gets a copy of each frame, without a recording.
    private static Measurements Measure(int recordings, bool isCopied = false)
    {
        using BareRing? ring = isCopied ? new BareRing() : null;
        byte[] packet = TestFrame.Create();
        ReceivePipeline pipeline = Pipelines.Create();
        int handled = 0;
        pipeline.Callbacks.Motion.Add(frame => handled += Math.Sign(frame.Values.Length));
        pipeline.Tap.Open(isDatagrams: false, local: null, remote: null, Stopwatch.GetTimestamp());
        StreamRecorder[] recorders = [.. Enumerable.Range(0, recordings).Select(_ => Start(pipeline.Tap))];
        var assembler = new PacketAssembler(new PacketScanner(), pipeline, pipeline.Tap);
        uint index = 0;
        Push();

        long allocated = 0;
        double elapsed = 0;
        for (int i = 0; i < Batches; i++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            double start = CpuClock.OfThread;
            Push();
            elapsed += CpuClock.OfThread - start;
            allocated += GC.GetAllocatedBytesForCurrentThread() - before;
            long pushed = Batch * (i + 2);
            while (ring?.FramesRead < pushed || !Array.TrueForAll(recorders, recorder => recorder.GetStatistics() is var done && done.Pieces + done.LostPieces >= pushed))
                Thread.Sleep(1);
        }

        foreach (StreamRecorder recorder in recorders)
            recorder.Dispose();
        if (handled != Batch * (Batches + 1) || recorders.Any(static recorder => recorder.GetStatistics().Pieces != Batch * (Batches + 1)))
            throw new InvalidOperationException("Not every frame was delivered and recorded.");

        return new Measurements
        {
            ["ns/frame"] = elapsed / (Batch * Batches),
            ["B/frame"] = allocated / (double)(Batch * Batches),
        };

        void Push()
        {
            for (int i = 0; i < Batch; i++)
            {
                TestFrame.SetIndex(packet, ++index);
                ring?.Write(packet);
                assembler.Push(packet, Stopwatch.GetTimestamp());
            }
        }
    }

    private static async Task<Measurements> MeasureOverTcpAsync(int recordings)
    {
        using Peer sender = await Peer.StartAsync("flood", "--per-write", Peer.Text(FramesPerWrite), "--frames", Peer.Text(FramesOverTcp), "--paced");
        DirectoryInfo folder = Directory.CreateTempSubdirectory("record");
        try
        {
            return await MeasureOverTcpAsync(sender, folder.FullName, recordings);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    private static async Task<Measurements> MeasureOverTcpAsync(Peer sender, string folder, int recordings)
    {
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });
        StreamRecorder[] recorders = [.. Enumerable.Range(0, recordings).Select(number => reader.StartRecording(Path.Combine(folder, $"{number}.nmrec")))];
        int handled = 0;
        double start = 0, end = 0;
        reader.MotionReceived += _ =>
        {
            if (++handled == 1)
                start = CpuClock.OfThread;
            if (handled == FramesOverTcp)
                end = CpuClock.OfThread;
        };
        reader.Start();
        await reader.Completion;
        foreach (StreamRecorder recorder in recorders)
            await recorder.Completion;

        if (handled != FramesOverTcp || recorders.Any(static recorder => recorder.GetStatistics().Bytes != FramesOverTcp * (long)TestFrame.Size))
            throw new InvalidOperationException("Not every frame was delivered and recorded.");

        return new Measurements { ["ns/frame"] = (end - start) / FramesOverTcp };
    }

    private static StreamRecorder Start(StreamTap tap) => new(
        "nowhere.nmrec", new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) }, RecordingMetadata.Empty, tap, static _ => { }, static (_, _) => Stream.Null);
}
