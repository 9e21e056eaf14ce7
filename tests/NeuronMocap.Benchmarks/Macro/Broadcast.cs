using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Benchmarks.Macro;

// The server and its clients, which run in another process. The floor is a thread for each client that sends the same bytes and nothing else. At a
// fixed rate, the cost of a frame is compared, on processors that are kept awake where the system can do that. At full speed, the number of frames is
// compared. The bare encoder is a raw loop that writes each frame before it sends it.
internal static class Broadcast
{
    private const double Rate = 120;

    // Frames at the start that do not count. Then everything is compiled, and the buffers of a client that never reads, which hold 424 frames, are full.
    private const int WarmFrames = 500;
    private const string WithIdler = "paced, one more client that never reads";
    public const string Cost = "CPU µs/frame and client";
    private const string MedianCost = "CPU µs/client, median frame";
    private const string Speed = "frames/s";

    private static readonly Aim[] Aims =
    [
        new(Cost, 1.15, IsRatio: true, Way: "paced"),
        new(Cost, 1.2, IsRatio: true, Way: WithIdler),
        new(Speed, 0.95, IsRatio: true, IsLowerBound: true, Way: "flat out"),
        new("lost", 0),
    ];

    public static async Task<int> RunAsync(int[] counts, double seconds, int runs, Report report)
    {
        report.Begin($"A server to its clients: {seconds} s at {Rate} Hz, then flat out, {runs} runs; the floor is a raw send loop for each client.");
        foreach (int count in counts)
        {
            string @case = count == 1 ? "1 client" : $"{count} clients";
            Way[] paced =
            [
                new("paced", () => PacedAsync(count, seconds, withIdler: false)),
                new(WithIdler, () => PacedAsync(count, seconds, withIdler: true)),
            ];
            using (OperatingSystem.IsLinux() ? await Peer.StartAsync("awake") : null)
                report.Add(await Alternation.RunAsync(@case, runs, new Way("raw", () => RawPacedAsync(count, seconds)), paced, Aims));

            int frames = 2_000_000 / count;
            Way raw = new("raw", () => RawFloodAsync(count, frames));
            Way[] flood = [new("flat out", () => FloodAsync(count, frames)), new("bare encoder", () => RawFloodAsync(count, frames, encodes: true))];
            report.Add(await Alternation.RunAsync(@case, runs, raw, flood, Aims));
        }

        return report.End();
    }

    // warmFrames: frames at the start that do not count.
    public static async Task<Measurements> PacedAsync(int count, double seconds, bool withIdler, double rate = Rate, int warmFrames = WarmFrames)
    {
        var costs = new FrameCosts(warmFrames);
        long frames = warmFrames + (long)(rate * seconds);
        using Broadcaster server = CreateServer(rate, frames, costs);
        server.Start();
        Measurements figures = await MeasureAsync(server.LocalEndPoint!.Port, count, withIdler, frames, costs, () => server.Completion);
        if (server.GetStatistics().FramesSent > (count * frames) + WarmFrames)
            throw new InvalidOperationException("The client that never reads still took frames.");

        return figures;
    }

    public static async Task<Measurements> FloodAsync(int count, int frames)
    {
        using Broadcaster server = CreateServer(BroadcasterOptions.MaxFrameRate, frames);
        server.Start();
        TimeSpan cpu = Environment.CpuUsage.TotalTime;
        using Peer sinks = await StartSinksAsync(server.LocalEndPoint!.Port, count, withIdler: false);
        (long received, _, _, double elapsed) = await ReadResultAsync(sinks);
        cpu = Environment.CpuUsage.TotalTime - cpu;
        return new Measurements { [Speed] = received * count / elapsed, [Check.Cpu] = cpu.TotalNanoseconds / ((double)received * count), ["lost"] = frames - received };
    }

    private static Broadcaster CreateServer(double rate, long frames, FrameCosts? costs = null) => new(new BroadcasterOptions
    {
        Sources = [new StillSource(costs)],
        Port = 0,
        FrameRate = rate,
        MaxFrames = frames,
        MaxClients = 1000,
        WaitForClient = true,
        CloseTimeout = TimeSpan.FromSeconds(1),
    });

    private static async Task<Measurements> RawPacedAsync(int count, double seconds)
    {
        using var listener = Listen(count);
        long frames = WarmFrames + (long)(Rate * seconds);
        var costs = new FrameCosts(WarmFrames);
        Task serving = ServeAsync(listener, count, (socket, client) =>
        {
            byte[] packet = TestFrame.Create();
            long start = Stopwatch.GetTimestamp();
            for (long frame = 0; frame < frames; frame++)
            {
                PacedSender.WaitUntil(start + (long)(frame / Rate * Stopwatch.Frequency));
                TestFrame.SetIndex(packet, (uint)frame);
                FloodSender.SendAll(socket, packet, packet.Length);
                if (client == 0)
                    costs.Count();
            }
        });
        return await MeasureAsync(((IPEndPoint)listener.LocalEndpoint).Port, count, withIdler: false, frames, costs, () => serving);
    }

    public static async Task<Measurements> RawFloodAsync(int count, int frames, bool encodes = false)
    {
        using var listener = Listen(count);
        const int PerWrite = 88;
        byte[] header = TestFrame.Create()[..ProtocolConstants.HeaderSize];
        TimeSpan cpu = Environment.CpuUsage.TotalTime;
        Task serving = ServeAsync(listener, count, (socket, _) =>
        {
            byte[] block = new byte[PerWrite * TestFrame.Size];
            for (int sent = 0; sent < frames; sent += PerWrite)
            {
                if (encodes)
                    Encode(block, header, sent);

                FloodSender.SendAll(socket, block, Math.Min(PerWrite, frames - sent) * TestFrame.Size);
            }
        });
        using Peer sinks = await StartSinksAsync(((IPEndPoint)listener.LocalEndpoint).Port, count, withIdler: false);
        (long received, _, _, double elapsed) = await ReadResultAsync(sinks);
        cpu = Environment.CpuUsage.TotalTime - cpu;
        await serving;
        return new Measurements { [Speed] = received * count / elapsed, [Check.Cpu] = cpu.TotalNanoseconds / ((double)received * count), ["lost"] = frames - received };
    }

    // Writes what the server writes for a source without motion.
    private static void Encode(Span<byte> block, ReadOnlySpan<byte> header, int index)
    {
        for (; !block.IsEmpty; block = block[TestFrame.Size..])
        {
            header.CopyTo(block);
            TestFrame.SetIndex(block, (uint)index++);
            block[header.Length..TestFrame.Size].Clear();
        }
    }

    private static async Task<Measurements> MeasureAsync(int port, int count, bool withIdler, long frames, FrameCosts costs, Func<Task> completion)
    {
        using Peer sinks = await StartSinksAsync(port, count, withIdler);
        (_, long missing, long last, _) = await ReadResultAsync(sinks);
        await completion();

        // The first client starts the frames, so the others miss the frames sent while they connect. These come before the first frame of each, and do not count.
        return new Measurements { [Cost] = costs.Mean / count, [MedianCost] = costs.Median / count, ["lost"] = missing + frames - 1 - last };
    }

    private static TcpListener Listen(int count)
    {
        var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start(count);
        return listener;
    }

    // send: gets the connection and the number of its client.
    private static Task ServeAsync(TcpListener listener, int count, Action<Socket, int> send) => Task.WhenAll(Enumerable.Range(0, count).Select(client => Task.Factory.StartNew(
        () =>
        {
            using Socket socket = listener.AcceptSocket();
            socket.NoDelay = true;
            send(socket, client);
            socket.Shutdown(SocketShutdown.Send);
            socket.Receive(new byte[1]);
        },
        CancellationToken.None,
        TaskCreationOptions.LongRunning,
        TaskScheduler.Default)));

    private static Task<Peer> StartSinksAsync(int port, int count, bool withIdler) =>
        Peer.StartAsync("sinks", "--port", Peer.Text(port), "--connections", Peer.Text(count), "--idler", withIdler ? "true" : "false");

    // What Sinks prints.
    private static async Task<(long Frames, long Missing, long Last, double Seconds)> ReadResultAsync(Peer sinks)
    {
        double[] parts = [.. (await sinks.ReadLineAsync()).Split(' ').Select(static part => double.Parse(part, CultureInfo.InvariantCulture))];
        return ((long)parts[0], (long)parts[1], (long)parts[2], parts[3]);
    }

    // It counts its frames, which cost as little as possible.
    internal sealed class StillSource(FrameCosts? costs = null) : Server.MotionSource
    {
        public override double FrameRate => Rate;

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override void GetPose(long frame, Span<BoneTransform> pose) => pose.Fill(BoneTransform.Identity);

        public override FootContacts GetFootContacts(long frame) => new(true, true);

        public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
        {
            values.Clear();
            costs?.Count();
        }
    }
}
