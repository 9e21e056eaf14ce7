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
// fixed rate, the cost of a frame is compared, on processors that are kept awake. At full speed, the number of frames is compared. The bare encoder is a
// raw loop that writes each frame before it sends it.
internal static class Broadcast
{
    private const double Rate = 120;
    private const string WithIdler = "paced, one more client that never reads";
    public const string Cost = "CPU µs/frame and client";
    private const string MedianCost = "CPU µs/client, median frame";
    private const string Speed = "frames/s";

    private static readonly Aim[] Aims =
    [
        new(MedianCost, 1.15, IsRatio: true, Way: "paced"),
        new(MedianCost, 1.2, IsRatio: true, Way: WithIdler),
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
            using (await Peer.StartAsync("awake"))
                report.Add(await Alternation.RunAsync(@case, runs, new Way("raw", () => RawPacedAsync(count, seconds)), paced, Aims));

            int frames = 2_000_000 / count;
            Way raw = new("raw", () => RawFloodAsync(count, frames));
            Way[] flood = [new("flat out", () => FloodAsync(count, frames)), new("bare encoder", () => RawFloodAsync(count, frames, encodes: true))];
            report.Add(await Alternation.RunAsync(@case, runs, raw, flood, Aims));
        }

        return report.End();
    }

    public static async Task<Measurements> PacedAsync(int count, double seconds, bool withIdler)
    {
        var costs = new FrameCosts();
        using Broadcaster server = CreateServer(Rate, (long)(Rate * seconds), costs);
        server.Start();
        return await MeasureAsync(server.LocalEndPoint!.Port, count, withIdler, (long)(Rate * seconds), costs, () => server.Completion);
    }

    public static async Task<Measurements> FloodAsync(int count, int frames)
    {
        using Broadcaster server = CreateServer(BroadcasterOptions.MaxFrameRate, frames);
        server.Start();
        TimeSpan cpu = Environment.CpuUsage.TotalTime;
        using Peer sinks = await StartSinksAsync(server.LocalEndPoint!.Port, count, withIdler: false);
        (long received, double elapsed) = await ReadResultAsync(sinks);
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
        byte[] packet = TestFrame.Create();
        long frames = (long)(Rate * seconds);
        var costs = new FrameCosts();
        int threads = 0;
        Task serving = ServeAsync(listener, count, socket =>
        {
            bool isFirst = Interlocked.Increment(ref threads) == 1;
            long start = Stopwatch.GetTimestamp();
            for (long frame = 0; frame < frames; frame++)
            {
                PacedSender.WaitUntil(start + (long)(frame / Rate * Stopwatch.Frequency));
                FloodSender.SendAll(socket, packet, packet.Length);
                if (isFirst)
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
        Task serving = ServeAsync(listener, count, socket =>
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
        (long received, double elapsed) = await ReadResultAsync(sinks);
        cpu = Environment.CpuUsage.TotalTime - cpu;
        await serving;
        return new Measurements { [Speed] = received * count / elapsed, [Check.Cpu] = cpu.TotalNanoseconds / ((double)received * count) };
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
        TimeSpan cpu = Environment.CpuUsage.TotalTime;
        (long received, _) = await ReadResultAsync(sinks);
        cpu = Environment.CpuUsage.TotalTime - cpu;
        await completion();

        // The first client starts the frames. The others miss the frames sent while they connect.
        bool all = received >= frames - (Rate * count / 100) - 12;
        return new Measurements { [Cost] = cpu.TotalMicroseconds / (received * count), [MedianCost] = costs.Median / count, ["lost"] = all ? 0 : frames - received };
    }

    private static TcpListener Listen(int count)
    {
        var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start(count);
        return listener;
    }

    private static Task ServeAsync(TcpListener listener, int count, Action<Socket> send) => Task.WhenAll(Enumerable.Range(0, count).Select(_ => Task.Factory.StartNew(
        () =>
        {
            using Socket socket = listener.AcceptSocket();
            socket.NoDelay = true;
            send(socket);
            socket.Shutdown(SocketShutdown.Send);
            socket.Receive(new byte[1]);
        },
        CancellationToken.None,
        TaskCreationOptions.LongRunning,
        TaskScheduler.Default)));

    private static Task<Peer> StartSinksAsync(int port, int count, bool withIdler) =>
        Peer.StartAsync("sinks", "--port", Peer.Text(port), "--connections", Peer.Text(count), "--idler", withIdler ? "true" : "false");

    private static async Task<(long Frames, double Seconds)> ReadResultAsync(Peer sinks)
    {
        string[] parts = (await sinks.ReadLineAsync()).Split(' ');
        return (long.Parse(parts[0], CultureInfo.InvariantCulture), double.Parse(parts[1], CultureInfo.InvariantCulture));
    }

    // Its frames cost as little as possible. Counts them.
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
