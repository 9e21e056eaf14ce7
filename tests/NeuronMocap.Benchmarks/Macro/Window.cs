using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;

namespace NeuronMocap.Benchmarks.Macro;

// Delivery on a window's thread: what a frame costs that thread beside the handler, and how long other messages of the window wait.
internal static class Window
{
    private const int Performers = 10;
    private const double Rate = 120;
    private const string Cost = "µs/frame";
    private const string Wait = "p99 wait ms";

    public static async Task<int> RunAsync(double seconds, int runs, Report report)
    {
        report.Begin($"{Performers} performers at {Rate} Hz on one window, {seconds} s a run, {runs} runs; the floor is the window without frames.");
        Aim[] aims = [new(Wait, 16), new(Cost, 2, Way: "empty handler"), new(Cost, 2, Way: "empty handler, ten readers"), new(Cost, 2, Way: "one thread, hot")];
        Way idle = new("no frames", () => RunIdleAsync(seconds));
        Way[] ways =
        [
            new("empty handler", () => RunAsync(seconds, readerCount: 1, TimeSpan.Zero)),
            new("empty handler, ten readers", () => RunAsync(seconds, Performers, TimeSpan.Zero)),
            new("handler of 0.3 ms", () => RunAsync(seconds, readerCount: 1, TimeSpan.FromTicks(3000))),
            new("handler of 2 ms", () => RunAsync(seconds, readerCount: 1, TimeSpan.FromMilliseconds(2))),
            new("one thread, hot", RunHot),
        ];
        report.Add(await Alternation.RunAsync("window", runs, idle, ways, aims));
        return report.End();
    }

    private static async Task<Measurements> RunIdleAsync(double seconds)
    {
        using var window = new WindowLoop();
        return new Measurements { [Wait] = Percentile(await ProbeAsync(window, Task.Delay(TimeSpan.FromSeconds(seconds)))) };
    }

    // All frames come from one server, or those of each performer from a server of its own.
    private static async Task<Measurements> RunAsync(double seconds, int readerCount, TimeSpan duration)
    {
        using var window = new WindowLoop();
        double rate = Rate * Performers / readerCount;
        using Peer sender = await Peer.StartAsync("pace", "--connections", $"{readerCount}", "--rate", Peer.Text(rate), "--seconds", Peer.Text(seconds));
        var readers = new NeuronReader[readerCount];
        var deliveries = new FrameDelivery[readerCount];
        for (int i = 0; i < readerCount; i++)
        {
            readers[i] = new NeuronReader(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });
            deliveries[i] = readers[i].OpenDelivery(new FrameDeliveryOptions { Context = window });
            deliveries[i].MotionReceived += _ => Spin(duration);
        }

        foreach (NeuronReader reader in readers)
            reader.Start();

        List<double> waits = await ProbeAsync(window, Task.WhenAll(readers.Select(static reader => reader.Completion)));
        double busy = Stopwatch.GetElapsedTime(0, window.Busy).TotalMilliseconds * 1e3;
        double frames = deliveries.Sum(static delivery => delivery.Delivered);
        foreach (NeuronReader reader in readers)
            reader.Dispose();

        var figures = new Measurements
        {
            [Wait] = Percentile(waits),
            ["dropped %"] = 100.0 * deliveries.Sum(static delivery => delivery.Dropped) / (Performers * Rate * seconds),
        };

        // A longer handler is often interrupted, and its interruptions would count.
        if (duration == TimeSpan.Zero)
            figures[Cost] = busy / frames;

        return figures;
    }

    // Only the run of each post is measured, one frame in each.
    private static Measurements RunHot()
    {
        var context = new OnePost();
        using var reader = new NeuronReader("127.0.0.1");
        using FrameDelivery delivery = reader.OpenDelivery(new FrameDeliveryOptions { Context = context });
        delivery.MotionReceived += static _ => { };
        var packet = new ReceivedPacket(PacketKind.Motion, TestFrame.Create(), 0, 0);
        long ticks = 0;
        Measurements figures = HotLoop.Measure(_ =>
        {
            ((IPacketConsumer)delivery).OnPacket(packet);
            long start = Stopwatch.GetTimestamp();
            context.Run();
            ticks += Stopwatch.GetTimestamp() - start;
        });
        return new Measurements { [Cost] = Stopwatch.GetElapsedTime(0, ticks).TotalMilliseconds * 1e3 / HotLoop.Rounds, ["B/frame"] = figures["B/frame"] };
    }

    // A message every few milliseconds until the end.
    private static async Task<List<double>> ProbeAsync(WindowLoop window, Task end)
    {
        List<double> waits = [];
        while (!end.IsCompleted)
        {
            waits.Add(await window.ProbeAsync());
            await Task.WhenAny(end, Task.Delay(3));
        }

        return waits;
    }

    // Omits the first tenth, in which code is still being compiled.
    private static double Percentile(List<double> waits) => Spread.Percentile([.. waits.Skip(waits.Count / 10).Order()], 0.99);

    private static void Spin(TimeSpan duration)
    {
        long end = Stopwatch.GetTimestamp() + (long)(duration.TotalSeconds * Stopwatch.Frequency);
        while (Stopwatch.GetTimestamp() < end)
            Thread.SpinWait(10);
    }

    // Holds the one post that is outstanding.
    private sealed class OnePost : SynchronizationContext
    {
        private SendOrPostCallback? _callback;

        public override void Post(SendOrPostCallback d, object? state) => _callback = d;

        public void Run()
        {
            SendOrPostCallback? callback = _callback;
            _callback = null;
            callback?.Invoke(null);
        }
    }
}
