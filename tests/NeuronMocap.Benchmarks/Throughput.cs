using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Delivery;

namespace NeuronMocap.Benchmarks;

// One TCP sender in its own process against one receiver: a raw socket that parses nothing, then each way of delivery, in turn.
internal static class Throughput
{
    private const int FloorBuffer = 256 * 1024;
    private const int QueueCapacity = 8192;

    public static async Task RunAsync(int frames, int runs, int[] writes)
    {
        Console.WriteLine($"{frames} frames of {Sender.FrameSize} bytes, {runs} runs in turn, {Environment.ProcessorCount} processors; medians");
        Console.WriteLine("frames/write   floor M/s   callback M/s  ratio   queue M/s  ratio   newest M/s  ratio   undelivered");
        foreach (int perWrite in writes)
        {
            List<double> floor = [];
            List<double>[] ways = [[], [], []];
            long lost = 0;
            for (int run = 0; run <= runs; run++)
            {
                double[] rates = [await FloorAsync(perWrite, frames), 0, 0, 0];
                for (int way = 0; way < 3; way++)
                {
                    (rates[way + 1], long missing) = await ReaderAsync((Way)way, perWrite, frames);
                    lost += missing;
                }

                // The first round warms up.
                if (run == 0)
                    continue;

                floor.Add(rates[0]);
                for (int way = 0; way < 3; way++)
                    ways[way].Add(rates[way + 1]);
            }

            double[] ratios = [.. ways.Select(rates => Median(rates.Zip(floor, static (rate, basis) => rate / basis)))];
            Console.WriteLine(
                $"{perWrite,12}{Median(floor) / 1e6,12:0.00}{Median(ways[0]) / 1e6,15:0.00}{ratios[0],7:0.00}"
                + $"{Median(ways[1]) / 1e6,12:0.00}{ratios[1],7:0.00}{Median(ways[2]) / 1e6,13:0.00}{ratios[2],7:0.00}{lost,14}");
        }
    }

    private static async Task<double> FloorAsync(int perWrite, int frames)
    {
        using Sender sender = await Sender.StartAsync(perWrite, frames);
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        socket.Connect(IPAddress.Loopback, sender.Port);
        byte[] buffer = new byte[FloorBuffer];
        long received = socket.Receive(buffer);
        long start = Stopwatch.GetTimestamp();
        for (int count = 1; count > 0; received += count)
            count = socket.Receive(buffer);

        return received / (double)Sender.FrameSize / Stopwatch.GetElapsedTime(start).TotalSeconds;
    }

    // Lost: frames that were sent and not delivered; newer frames replace older ones in the newest way, so there it counts what was received.
    private static async Task<(double Rate, long Lost)> ReaderAsync(Way way, int perWrite, int frames)
    {
        using Sender sender = await Sender.StartAsync(perWrite, frames);
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = sender.Port, Reconnect = { Enabled = false } });
        long counted = 0;
        using FrameQueue? queue = way == Way.Queue ? reader.OpenQueue(QueueCapacity) : null;
        using LatestFrames? latest = way == Way.Newest ? reader.OpenLatest() : null;
        if (way == Way.Callback)
            reader.MotionReceived += _ => counted++;

        reader.Start();
        while (!reader.Completion.IsCompleted)
        {
            if (queue is not null)
                counted += queue.Pump(static _ => { });
            else if (latest is not null)
                latest.TryTakeMotion(0, out _);
            else
                await reader.Completion;

            if (way != Way.Callback)
                Thread.Yield();
        }

        counted += queue?.Pump(static _ => { }) ?? 0;
        ReaderStatistics statistics = reader.GetStatistics();
        long delivered = way == Way.Newest ? statistics.MotionFrames : counted;
        return (statistics.MotionFrames / statistics.Duration.TotalSeconds, frames - delivered);
    }

    private static double Median(IEnumerable<double> values)
    {
        double[] sorted = [.. values.Order()];
        return sorted[sorted.Length / 2];
    }

    private enum Way
    {
        Callback,
        Queue,
        Newest,
    }
}
