using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// Many servers at an ordinary rate, each with its own reader, all in this process. The floor is one of them.
internal static class Streams
{
    public const string Cost = "CPU µs/frame";
    private const double Rate = 60;

    private static readonly Aim[] Aims = [new(Cost, 1, IsRatio: true), new("cores", 1), new("lost", 0), new("managed KiB/connection", 64), new("threads", 64)];

    public static async Task<int> RunAsync(int[] counts, double seconds, int runs, Report report)
    {
        report.Begin($"Connections at {Rate} Hz in one process, {seconds} s a run, {runs} runs; the floor is one connection.");
        foreach (int count in counts)
        {
            Way floor = new("1 connection", () => MeasureAsync(1, seconds));
            report.Add(await Alternation.RunAsync($"{count} connections", runs, floor, [new Way("callback", () => MeasureAsync(count, seconds))], Aims));
        }

        return report.End();
    }

    public static async Task<Measurements> MeasureAsync(int connections, double seconds)
    {
        long memoryBefore = LiveHeap();
        using Peer sender = await Peer.StartAsync(
            "pace", "--connections", Peer.Text(connections), "--rate", Peer.Text(Rate), "--seconds", Peer.Text(seconds + 2));
        long frames = 0;
        NeuronReader[] readers = new NeuronReader[connections];
        for (int i = 0; i < connections; i++)
        {
            readers[i] = new NeuronReader(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });
            readers[i].MotionReceived += _ => Interlocked.Increment(ref frames);
        }

        await Task.WhenAll(readers.Select(static reader => reader.StartAsync()));
        await Task.Delay(TimeSpan.FromSeconds(1));

        var process = Process.GetCurrentProcess();
        long allocated = GC.GetTotalAllocatedBytes(precise: true);
        TimeSpan cpu = process.TotalProcessorTime;
        long counted = Interlocked.Read(ref frames);
        var watch = Stopwatch.StartNew();
        await Task.Delay(TimeSpan.FromSeconds(seconds));
        process.Refresh();
        cpu = process.TotalProcessorTime - cpu;
        counted = Interlocked.Read(ref frames) - counted;
        allocated = GC.GetTotalAllocatedBytes(precise: true) - allocated;
        TimeSpan elapsed = watch.Elapsed;
        int threads = process.Threads.Count;
        long memory = LiveHeap() - memoryBefore;

        await Task.WhenAll(readers.Select(static reader => reader.Completion));
        foreach (NeuronReader reader in readers)
            await reader.DisposeAsync();

        long sent = (long)(Rate * (seconds + 2)) * connections;
        return new Measurements
        {
            [Cost] = cpu.TotalMicroseconds / counted,
            ["cores"] = cpu / elapsed,
            ["lost"] = sent - Interlocked.Read(ref frames),
            ["managed KiB/connection"] = memory / 1024.0 / connections,
            ["threads"] = threads,
            ["B/frame"] = allocated / (double)counted,
        };
    }

    // The collector's own count of reachable memory. It is exact after a compacting collection.
    private static long LiveHeap()
    {
        GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true);
        return GC.GetGCMemoryInfo(GCKind.FullBlocking).HeapSizeBytes - GC.GetGCMemoryInfo(GCKind.FullBlocking).FragmentedBytes;
    }
}
