using System.Diagnostics;
using System.Net.Sockets;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Server;

namespace NeuronMocap.Benchmarks.Macro;

// A reader and a broadcaster between a sender in another process and a client in this one. One frame at a time, the floor is the same client without them.
// At full speed, the floor is the broadcaster alone. The least that any relay costs is a loop that receives and sends, without parsing: the bare relay.
internal static class Relay
{
    private const string Speed = "frames/s";
    private const string Lost = "lost frames";
    private const int FramesPerWrite = 32;

    public static async Task<int> RunAsync(double[] rates, int frames, double seconds, int runs, Report report)
    {
        report.Begin($"A relay from TCP to TCP: one frame at a time for {seconds} s, then {frames} frames flat out, {runs} runs.");
        foreach (double rate in rates)
        {
            double floor = 0;
            Way raw = new("raw", async () =>
            {
                Measurements figures = await Latency.FloorAsync(rate, seconds);
                floor = figures[Latency.Median];
                return figures;
            });
            Way[] ways =
            [
                new("bare relay", () => BarePacedAsync(rate, seconds, others: 0, floor)),
                new("relay", () => PacedAsync(rate, seconds, others: 0, hasOwn: false, floor)),
                new("bare relay, 9 more clients, all read", () => BarePacedAsync(rate, seconds, others: 9, floor)),
                new("relay, 9 more clients, one never reads", () => PacedAsync(rate, seconds, others: 9, hasOwn: false, floor)),
                new("relay, 9 more destinations, one never reads", () => PacedAsync(rate, seconds, others: 9, hasOwn: true, floor)),
            ];
            report.Add(await Alternation.RunAsync($"{rate} Hz", runs, raw, ways, [new Aim(Latency.Added, 30, Way: "relay")]));
        }

        Way alone = new("broadcaster", () => BroadcastAsync(frames));
        Way[] flood = [new("relay", () => FloodAsync(frames)), new("bare relay", () => BareFloodAsync(frames)), new("the relay's sender alone", () => SenderAsync(frames))];
        report.Add(await Alternation.RunAsync("flat out", runs, alone, flood, [new Aim(Speed, 0.8, IsRatio: true, IsLowerBound: true, Way: "relay")]));
        return report.End();
    }

    // hasOwn: whether each of the other clients has a destination of its own.
    private static async Task<Measurements> PacedAsync(double rate, double seconds, int others, bool hasOwn, double floor)
    {
        using Peer sender = await Latency.StartSenderAsync(rate, seconds);
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });
        Broadcaster[] relays = [.. Enumerable.Range(0, hasOwn ? others + 1 : 1).Select(_ => Start(reader, queueCapacity: 256))];
        int[] ports = [.. relays.Select(static relay => relay.LocalEndPoint!.Port)];
        Measurements figures = await MeasurePacedAsync(rate, seconds, others, floor, neverReads: 1, i => ports[i % ports.Length], async () =>
        {
            while (relays.Sum(static relay => relay.GetStatistics().Clients) < others + 1)
                await Task.Delay(1);

            reader.Start();
        });
        foreach (Broadcaster relay in relays)
            relay.Dispose();

        return figures;
    }

    private static async Task<Measurements> BarePacedAsync(double rate, double seconds, int others, double floor)
    {
        using Peer sender = await Latency.StartSenderAsync(rate, seconds);
        using var relay = new BareRelay();
        return await MeasurePacedAsync(rate, seconds, others, floor, neverReads: 0, _ => relay.Port, () => relay.StartAsync(sender.Port, others + 1));
    }

    // The last client is the one that is measured.
    private static async Task<Measurements> MeasurePacedAsync(
        double rate, double seconds, int others, double floor, int neverReads, Func<int, int> portOf, Func<Task> start)
    {
        Socket[] clients = [.. Enumerable.Range(0, others).Select(i => RawReceiver.Connect(portOf(i)))];
        Task draining = Task.WhenAll(clients.Skip(neverReads).Select(socket => DrainAsync(socket)));
        Task<Measurements> measuring = Task.Factory.StartNew(
            () => Latency.Measure(portOf(others), rate, seconds), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        await start();
        Measurements figures = await measuring;
        await draining;
        foreach (Socket client in clients)
            client.Dispose();

        figures[Latency.Added] = figures[Latency.Median] - floor;
        return figures;
    }

    private static Task<Peer> StartSenderAsync(int frames) =>
        Peer.StartAsync("flood", "--per-write", Peer.Text(FramesPerWrite), "--frames", Peer.Text(frames));

    private static async Task<Measurements> SenderAsync(int frames)
    {
        using Peer sender = await StartSenderAsync(frames);
        using Socket client = RawReceiver.Connect(sender.Port);
        return await MeasureAsync(client, frames);
    }

    private static async Task<Measurements> BareFloodAsync(int frames)
    {
        using Peer sender = await StartSenderAsync(frames);
        using var relay = new BareRelay();
        using Socket client = RawReceiver.Connect(relay.Port);
        await relay.StartAsync(sender.Port, clients: 1);
        return await MeasureAsync(client, frames);
    }

    private static async Task<Measurements> FloodAsync(int frames)
    {
        using Peer sender = await StartSenderAsync(frames);
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });
        using Broadcaster relay = Start(reader, queueCapacity: 4096);
        using Socket client = RawReceiver.Connect(relay.LocalEndPoint!.Port);
        await WaitForClientsAsync(relay, count: 1);
        reader.Start();
        return await MeasureAsync(client, frames);
    }

    private static async Task<Measurements> BroadcastAsync(int frames)
    {
        using var server = new Broadcaster(new BroadcasterOptions
        {
            Sources = [new Broadcast.StillSource()],
            Port = 0,
            FrameRate = BroadcasterOptions.MaxFrameRate,
            MaxFrames = frames,
        });
        server.Start();
        using Socket client = RawReceiver.Connect(server.LocalEndPoint!.Port);
        return await MeasureAsync(client, frames);
    }

    private static Broadcaster Start(NeuronReader reader, int queueCapacity)
    {
        var relay = new Broadcaster(new BroadcasterOptions { Reader = reader, Port = 0, QueueCapacity = queueCapacity, CloseTimeout = TimeSpan.FromSeconds(1) });
        relay.Start();
        return relay;
    }

    private static async Task WaitForClientsAsync(Broadcaster relay, int count)
    {
        while (relay.GetStatistics().Clients < count)
            await Task.Delay(1);
    }

    private static async Task<Measurements> MeasureAsync(Socket client, int frames)
    {
        long start = Stopwatch.GetTimestamp();
        long received = await DrainAsync(client) / TestFrame.Size;
        return new Measurements { [Speed] = received / Stopwatch.GetElapsedTime(start).TotalSeconds, [Lost] = frames - received };
    }

    private static Task<long> DrainAsync(Socket socket) => Task.Factory.StartNew(
        () =>
        {
            byte[] buffer = new byte[RawReceiver.BufferSize];
            long total = 0;
            while (socket.Receive(buffer) is > 0 and var count)
                total += count;

            socket.Dispose();
            return total;
        },
        CancellationToken.None,
        TaskCreationOptions.LongRunning,
        TaskScheduler.Default);
}
