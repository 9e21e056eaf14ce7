using System.Collections.Concurrent;
using System.Diagnostics;
using System.IO.Pipelines;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;
using NeuronMocap.RabbitMq;
using NeuronMocap.Tests.RabbitMq;

namespace NeuronMocap.Benchmarks.Macro;

// Avatars at 60 Hz through a broker on this computer to several readers, all in this process. The floor is a handler of the publisher's reader.
internal static class Rabbit
{
    private const int Rate = 60;
    private const string Lost = "lost frames";

    public static async Task<int> RunAsync(int avatars, int consumers, double seconds, int runs, Report report)
    {
        if (Broker.Missing is { } reason)
        {
            await Console.Error.WriteLineAsync(reason);
            return 1;
        }

        report.Begin($"{avatars} avatars × {Rate} Hz over a broker to {consumers} readers, {seconds} s a run, {runs} runs; the floor is the publisher's reader.");
        await using Broker broker = await Broker.StartAsync();
        double floor = 0;
        Way local = new("local", async () =>
        {
            Measurements figures = await MeasureAsync(broker, avatars, consumers: 0, seconds);
            floor = figures[Latency.Median];
            return figures;
        });
        Way[] ways =
        [
            new("live", () => MeasureAsync(broker, avatars, consumers, seconds, added: floor)),
            new("live, kept in a stream", () => MeasureAsync(broker, avatars, consumers, seconds, "take", floor)),
        ];
        report.Add(await Alternation.RunAsync($"{avatars} × {Rate} Hz", runs, local, ways, [new Aim(Latency.Added, 2000), new Aim(Lost, 0)]));
        return report.End();
    }

    private static async Task<Measurements> MeasureAsync(Broker broker, int avatars, int consumers, double seconds, string? stream = null, double added = 0)
    {
        var delays = new ConcurrentBag<List<double>>();
        var pipe = new Pipe(new PipeOptions(pauseWriterThreshold: 0));
        await using var reader = new NeuronReader(pipe.Reader);
        var publish = RabbitMqPublisherOptions.Parse($"{broker.Address}?stage=bench");
        publish.Stream = stream;
        await using var publisher = new RabbitMqPublisher(reader, publish);
        await publisher.StartAsync();
        var sources = new List<RabbitMqSource>();
        var readers = new List<NeuronReader>();
        for (int i = 0; i < consumers; i++)
        {
            var source = new RabbitMqSource(RabbitMqSourceOptions.Parse($"{broker.Address}?stage=bench"));
            var audience = new NeuronReader(new NeuronReaderOptions { Source = source });
            sources.Add(source);
            readers.Add(audience);
            Collect(audience, delays);
            audience.Start();
        }

        if (consumers == 0)
            Collect(reader, delays);

        while (!sources.TrueForAll(static source => source.GetStatistics().Connections > 0))
            await Task.Delay(1);

        reader.Start();
        long frames = await Task.Factory.StartNew(
            () => Write(pipe.Writer, avatars, seconds), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        await pipe.Writer.CompleteAsync();
        await publisher.Completion;

        // A frame that is lost at the end arrives at no reader, so this waits for a limited time.
        long start = Stopwatch.GetTimestamp();
        while (!sources.TrueForAll(source => Arrived(source) == frames) && Stopwatch.GetElapsedTime(start).TotalSeconds < 20)
            await Task.Delay(1);

        foreach (NeuronReader audience in readers)
            await audience.DisposeAsync();

        double[] sorted = [.. delays.SelectMany(static list => list).Order()];
        return new Measurements
        {
            [Latency.Median] = Spread.Percentile(sorted, 0.5),
            [Latency.Tail] = Spread.Percentile(sorted, 0.99),
            [Latency.Added] = Spread.Percentile(sorted, 0.5) - added,
            [Lost] = (frames * Math.Max(consumers, 1)) - sorted.Length,
        };
    }

    private static long Arrived(RabbitMqSource source)
    {
        RabbitMqSourceStatistics statistics = source.GetStatistics();
        return statistics.Packets + statistics.Lost;
    }

    private static void Collect(NeuronReader reader, ConcurrentBag<List<double>> delays)
    {
        var own = new List<double>();
        delays.Add(own);
        reader.MotionReceived += frame =>
            own.Add((Stopwatch.GetTimestamp() - TestFrame.GetTime(System.Runtime.InteropServices.MemoryMarshal.AsBytes(frame.Values))) * 1e6 / Stopwatch.Frequency);
    }

    // Spreads the frames over the time, as servers that do not know of each other do.
    private static long Write(PipeWriter writer, int avatars, double seconds)
    {
        byte[][] packets = [.. Enumerable.Range(0, avatars).Select(static avatar => TestFrame.Create(avatar))];
        long start = Stopwatch.GetTimestamp();
        long total = (long)(avatars * Rate * seconds);
        for (long written = 0; written < total;)
        {
            long due = Math.Min(total, (long)(Stopwatch.GetElapsedTime(start).TotalSeconds * avatars * Rate));
            for (; written < due; written++)
            {
                byte[] packet = packets[written % avatars];
                TestFrame.SetIndex(packet, (uint)(written / avatars));
                TestFrame.SetTime(packet, Stopwatch.GetTimestamp());
                packet.CopyTo(writer.GetSpan(packet.Length));
                writer.Advance(packet.Length);
            }

            writer.FlushAsync().AsTask().GetAwaiter().GetResult();
            Thread.Sleep(1);
        }

        return total;
    }
}
