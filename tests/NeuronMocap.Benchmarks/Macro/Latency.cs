using System.Diagnostics;
using System.Net.Sockets;
using System.Runtime.InteropServices;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// One frame at a time, from just before the sender passes it to the system until the handler runs. Both processes read the same clock.
internal static class Latency
{
    public const string Median = "median µs";
    public const string Tail = "p99 µs";
    public const string Added = "added median µs";

    public static async Task<int> RunAsync(double[] rates, double seconds, int runs, Report report)
    {
        report.Begin($"Microseconds from just before send to the handler, {seconds} s a run, {runs} runs; the floor is a blocking receive of the same frames.");
        foreach (double rate in rates)
        {
            double floor = 0;
            Way raw = new("raw", async () =>
            {
                Measurements figures = await FloorAsync(rate, seconds);
                floor = figures[Median];
                return figures;
            });
            Way callback = new("callback", async () =>
            {
                Measurements figures = await CallbackAsync(rate, seconds);
                figures[Added] = figures[Median] - floor;
                return figures;
            });
            report.Add(await Alternation.RunAsync($"{rate} Hz", runs, raw, [callback], [new Aim(Tail, 1.25, IsRatio: true), new Aim(Added, 10)]));
        }

        return report.End();
    }

    public static Task<Peer> StartSenderAsync(double rate, double seconds) =>
        Peer.StartAsync("pace", "--connections", "1", "--rate", Peer.Text(rate), "--seconds", Peer.Text(seconds));

    public static async Task<Measurements> FloorAsync(double rate, double seconds)
    {
        using Peer sender = await StartSenderAsync(rate, seconds);
        return Measure(sender.Port, rate, seconds);
    }

    // A blocking receive, until the other side ends the connection.
    public static Measurements Measure(int port, double rate, double seconds)
    {
        using Socket socket = RawReceiver.Connect(port);
        byte[] buffer = new byte[RawReceiver.BufferSize];
        List<double> delays = new((int)(rate * seconds));
        while (socket.Receive(buffer) is > 0 and var count)
        {
            long now = Stopwatch.GetTimestamp();
            if (count == TestFrame.Size)
                delays.Add(Microseconds(buffer.AsSpan(TestFrame.HeaderSize), now));
        }

        return ToFigures(delays);
    }

    private static async Task<Measurements> CallbackAsync(double rate, double seconds)
    {
        using Peer sender = await StartSenderAsync(rate, seconds);
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });
        List<double> delays = new((int)(rate * seconds));
        reader.MotionReceived += frame => delays.Add(Microseconds(MemoryMarshal.AsBytes(frame.Values), Stopwatch.GetTimestamp()));
        reader.Start();
        await reader.Completion;
        return ToFigures(delays);
    }

    private static double Microseconds(ReadOnlySpan<byte> values, long now) => (now - TestFrame.GetTime(values)) * 1e6 / Stopwatch.Frequency;

    // Omits the first tenth, in which code is still being compiled.
    private static Measurements ToFigures(List<double> delays)
    {
        double[] sorted = [.. delays.Skip(delays.Count / 10).Order()];
        return new Measurements { [Median] = Spread.Percentile(sorted, 0.5), [Tail] = Spread.Percentile(sorted, 0.99) };
    }
}
