using System.IO.Pipelines;
using System.Net.Sockets;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// The same bytes as a connection, as a stream and as a pipe. Threads are compared with threads, and pool threads with pool threads.
internal static class Pipes
{
    private const string Cpu = "CPU ns/frame";
    private const double PacedRate = 60;

    private static readonly Aim[] Aims = [new(Cpu, 1.05, IsRatio: true), new("lost", 0)];

    // As large as the buffer of a connection on pool threads.
    private static readonly StreamPipeReaderOptions Segments = new(bufferSize: 64 * 1024);

    private static readonly Source[] OfThreads = [new("stream, thread", static port => new NeuronReader(Open(port), Options(port, ReceiveThread.Dedicated)))];

    private static readonly Source[] OfPool =
    [
        new("stream", static port => new NeuronReader(Open(port), Options(port, ReceiveThread.Pool))),
        new("pipe", static port => new NeuronReader(PipeReader.Create(Open(port), Segments), Options(port, ReceiveThread.Pool))),
    ];

    public static async Task<int> RunAsync(int frames, int runs, int[] writes, int connections, double seconds, Report report)
    {
        report.Begin($"{frames} frames of {TestFrame.Size} bytes over loopback TCP, or {connections} connections at {PacedRate} Hz for {seconds} s; {runs} runs. "
            + "The floor is a reader of the connection itself, on the same kind of thread.");
        foreach (int perWrite in writes)
        {
            report.Add(await MeasureAsync($"{perWrite} frames/write", ReceiveThread.Dedicated, OfThreads, create => FloodAsync(perWrite, frames, create)));
            report.Add(await MeasureAsync($"{perWrite} frames/write", ReceiveThread.Pool, OfPool, create => FloodAsync(perWrite, frames, create)));
        }

        report.Add(await MeasureAsync($"{connections} connections", ReceiveThread.Pool, OfPool, create => PaceAsync(connections, seconds, create)));
        return report.End();

        Task<List<Row>> MeasureAsync(string @case, ReceiveThread thread, Source[] ways, Func<Func<int, NeuronReader>, Task<Measurements>> run) => Alternation.RunAsync(
            @case,
            runs,
            new Way("connection", () => run(port => new NeuronReader(Options(port, thread)))),
            [.. ways.Select(way => new Way(way.Name, () => run(way.Create)))],
            Aims);
    }

    private static async Task<Measurements> FloodAsync(int perWrite, int frames, Func<int, NeuronReader> create)
    {
        using Peer sender = await Peer.StartAsync("flood", "--per-write", Peer.Text(perWrite), "--frames", Peer.Text(frames));
        return await ReceiveAsync([create(sender.Port)], frames);
    }

    private static async Task<Measurements> PaceAsync(int connections, double seconds, Func<int, NeuronReader> create)
    {
        using Peer sender = await Peer.StartAsync(
            "pace", "--connections", Peer.Text(connections), "--rate", Peer.Text(PacedRate), "--seconds", Peer.Text(seconds));
        return await ReceiveAsync([.. Enumerable.Range(0, connections).Select(_ => create(sender.Port))], (long)(PacedRate * seconds) * connections);
    }

    // Measured from an early frame to the last one, because connecting and ending cost time and memory, too.
    private static async Task<Measurements> ReceiveAsync(NeuronReader[] readers, long frames)
    {
        long first = frames / 3;
        long counted = 0;
        TimeSpan cpu = default;
        long allocated = 0;
        void Count(MotionFrame frame)
        {
            long count = Interlocked.Increment(ref counted);
            if (count == first)
                (cpu, allocated) = (RuntimeFigures.CpuTime, RuntimeFigures.AllocatedBytes!.Value);
            else if (count == frames)
                (cpu, allocated) = (RuntimeFigures.CpuTime - cpu, RuntimeFigures.AllocatedBytes!.Value - allocated);
        }

        foreach (NeuronReader reader in readers)
        {
            reader.MotionReceived += Count;
            reader.Start();
        }

        foreach (NeuronReader reader in readers)
        {
            await reader.Completion;
            await reader.DisposeAsync();
        }

        return new Measurements
        {
            [Cpu] = cpu.TotalNanoseconds / (frames - first),
            ["lost"] = frames - counted,
            ["B/frame"] = allocated / (double)(frames - first),
        };
    }

    private static NetworkStream Open(int port) => new(RawReceiver.Connect(port), ownsSocket: true);

    private static NeuronReaderOptions Options(int port, ReceiveThread thread) => new() { Port = port, ReceiveThread = thread, Reconnect = { Enabled = false } };

    private sealed record Source(string Name, Func<int, NeuronReader> Create);
}
