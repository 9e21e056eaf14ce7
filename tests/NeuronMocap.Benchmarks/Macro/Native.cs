using System.Globalization;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// Compares the C library with a C receiver that parses nothing. Both are processes of their own, programs of tests/native.
internal sealed class Native(DirectoryInfo programs, int runs, Report report)
{
    private const string Rate = "frames/s";
    private const string Cpu = "CPU ns/frame";
    private const string Median = "median µs";
    private const string Tail = "p99 µs";
    private const string Added = "added median µs";
    private const string Lost = "lost";

    private static readonly Aim[] Aims =
    [
        new(Rate, 0.9, IsRatio: true, IsLowerBound: true, Way: "library"),
        new(Tail, 1.25, IsRatio: true),
        new(Added, 10),
        new(Lost, 0),
        new("wrong", 0),
        new("allocations", 0),
    ];

    private static readonly Aim[] UdpAims = [.. Aims.Where(static aim => aim.Figure != Added), new(Added, 25)];

    // Starts a receiver: mode, port, frames.
    public delegate NativeReceiver Starter(string mode, int port, long frames);

    private readonly FileInfo _raw = new(Path.Combine(programs.FullName, "bench-raw"));
    private readonly FileInfo _library = new(Path.Combine(programs.FullName, "bench-library"));

    public async Task<int> RunAsync(int frames, int[] writes, double[] rates, double seconds)
    {
        report.Begin($"{frames} frames of {TestFrame.Size} bytes over loopback TCP to the C library's callback, {runs} runs; the floor is a blocking receive in C.");
        foreach (int perWrite in writes)
        {
            await CompareAsync($"{perWrite} frames/write", program => FloodAsync(From(program), "throughput", perWrite, frames));
            await CompareAsync($"{perWrite} frames/write, values read", program => FloodAsync(From(program), "check", perWrite, frames), aims: Aims[1..]);
        }

        foreach (double rate in rates)
        {
            await CompareAsync($"{rate} Hz", program => PaceAsync(From(program), rate, seconds), addsTo: Median);
            await CompareAsync($"{rate} Hz, UDP", program => PaceDatagramsAsync(program, rate, seconds), addsTo: Median, aims: UdpAims);
        }

        await CompareAsync("start", StartAsync);
        return report.End();
    }

    private async Task CompareAsync(string @case, Func<FileInfo, Task<Measurements>> measure, string? addsTo = null, IReadOnlyList<Aim>? aims = null)
    {
        double floor = 0;
        Way raw = new("raw", async () =>
        {
            Measurements figures = await measure(_raw);
            floor = addsTo is null ? 0 : figures[addsTo];
            return figures;
        });
        Way library = new("library", async () =>
        {
            Measurements figures = await measure(_library);
            if (addsTo is not null)
                figures[Added] = figures[addsTo] - floor;

            return figures;
        });
        report.Add(await Alternation.RunAsync(@case, runs, raw, [library], aims ?? Aims));
    }

    private static Starter From(FileInfo program) => (mode, port, frames) => NativeReceiver.Start(program, mode, port, frames);

    // In checked mode, the receiver adds up all words of the stream, as the sender does.
    public static async Task<Measurements> FloodAsync(Starter start, string mode, int perWrite, int frames)
    {
        using Peer sender = await Peer.StartAsync("flood", "--per-write", Peer.Text(perWrite), "--frames", Peer.Text(frames));
        using NativeReceiver receiver = start(mode, sender.Port, frames);
        Dictionary<string, ulong> told = await receiver.ReadFiguresAsync();
        var figures = new Measurements
        {
            [Rate] = told["frames"] * 1e9 / told["nanoseconds"],
            [Cpu] = told["cpu"] / (double)frames,
            [Lost] = frames - (double)told["frames"],
        };
        if (told.TryGetValue("sum", out ulong sum))
        {
            figures["wrong"] = sum == ulong.Parse(await sender.ReadLineAsync(), CultureInfo.InvariantCulture) ? 0 : 1;
            foreach (string figure in (string[])["allocations", "faults", "resident"])
                figures[figure] = told.GetValueOrDefault(figure);
        }

        return figures;
    }

    public static async Task<Measurements> PaceAsync(Starter start, double rate, double seconds)
    {
        using Peer sender = await Peer.StartAsync("pace", "--connections", "1", "--rate", Peer.Text(rate), "--seconds", Peer.Text(seconds));
        using NativeReceiver receiver = start("latency", sender.Port, (long)(rate * seconds));
        return ToFigures(await receiver.ReadLinesAsync(), (long)(rate * seconds), isWhole: false);
    }

    private static async Task<Measurements> PaceDatagramsAsync(FileInfo program, double rate, double seconds)
    {
        int port = PacedSender.FreePort();
        using NativeReceiver receiver = NativeReceiver.Start(program, "udp", port, (long)(rate * seconds));
        await receiver.WaitUntilReadyAsync();
        using Peer sender = await Peer.StartAsync("pace", "--udp", Peer.Text(port), "--rate", Peer.Text(rate), "--seconds", Peer.Text(seconds));
        return ToFigures(await receiver.ReadLinesAsync(), (long)(rate * seconds), isWhole: true);
    }

    private static async Task<Measurements> StartAsync(FileInfo program)
    {
        using Peer sender = await Peer.StartAsync("pace", "--connections", "1", "--rate", "1000", "--seconds", "0.1");
        using NativeReceiver receiver = NativeReceiver.Start(program, "start", sender.Port, frames: 0);
        Dictionary<string, ulong> told = await receiver.ReadFiguresAsync();
        return new Measurements
        {
            ["process to main µs"] = told["loaded"] / 1e3,
            ["process to first call returned µs"] = told["call"] / 1e3,
            ["connect µs"] = told["connect"] / 1e3,
            ["connected to first frame µs"] = told["frame"] / 1e3,
        };
    }

    // Omits the first tenth, as in the other latencies. The floor does not count two frames that arrive together, so it may miss some.
    private static Measurements ToFigures(string[] nanoseconds, long frames, bool isWhole)
    {
        double[] sorted = [.. nanoseconds.Skip(nanoseconds.Length / 10).Select(static text => double.Parse(text, CultureInfo.InvariantCulture) / 1e3).Order()];
        var figures = new Measurements { [Median] = Spread.Percentile(sorted, 0.5), [Tail] = Spread.Percentile(sorted, 0.99) };
        if (isWhole)
            figures[Lost] = frames - nanoseconds.Length;

        return figures;
    }
}
