using System.Diagnostics;
using System.Diagnostics.Metrics;
using System.Reflection;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Telemetry;

// The meter of all readers of the process. Its counters are observable. When a listener asks, they read the existing counts, so they cost the receive
// thread nothing. References to readers are weak, so a forgotten reader can be collected.
internal static class NeuronMeter
{
    private const string Prefix = "neuron.reader.";

    private static readonly object Lock = new();
    private static readonly List<(string Name, WeakReference<ReaderMetrics> Reader)> Readers = [];

    private static readonly (SkipReason Reason, string Tag)[] SkipReasons =
    [
        (SkipReason.NoTokens, "no_tokens"),
        (SkipReason.UnknownVersion, "unknown_version"),
        (SkipReason.TooLarge, "too_large"),
        (SkipReason.Incomplete, "incomplete"),
        (SkipReason.MalformedLine, "malformed_line"),
        (SkipReason.AmbiguousName, "ambiguous_name"),
        (SkipReason.TooManySenders, "too_many_senders"),
        (SkipReason.NotCalculation, "not_calculation"),
        (SkipReason.MissingAvatar, "missing_avatar"),
    ];

    private static readonly (ConnectionState State, string Tag)[] States =
        [.. Enum.GetValues<ConnectionState>().Select(static state => (state, state.ToString().ToLowerInvariant()))];

    private static readonly Meter Meter = CreateMeter();

    // The intervals of 120 and 60 Hz, of half and a third of these rates, and of a network outage.
    public static Histogram<double> FrameInterval { get; } = CreateHistogram(
        "frame.interval",
        "Time between two frames of the same avatar.",
        [0.001, 0.002, 0.004, 0.006, 0.008, 0.009, 0.012, 0.016, 0.018, 0.025, 0.034, 0.05, 0.1, 0.25, 0.5, 1, 5]);

    public static Histogram<double> HandOver { get; } = CreateHistogram(
        "handover.duration",
        "Time from the reception of a frame until the application took it.",
        [0.00001, 0.00005, 0.0001, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 5]);

    // Returns the name under which the reader reports. Readers of the same name get numbers, because their figures would otherwise replace each other.
    public static string Add(string name, ReaderMetrics reader)
    {
        lock (Lock)
        {
            Readers.RemoveAll(static entry => !entry.Reader.TryGetTarget(out _));
            string free = name;
            for (int number = 2; Readers.Exists(entry => string.Equals(entry.Name, free, StringComparison.Ordinal)); number++)
                free = $"{name} ({number})";

            Readers.Add((free, new WeakReference<ReaderMetrics>(reader)));
            return free;
        }
    }

    public static void Remove(ReaderMetrics reader)
    {
        lock (Lock)
            Readers.RemoveAll(entry => !entry.Reader.TryGetTarget(out ReaderMetrics? other) || ReferenceEquals(other, reader));
    }

    private static Meter CreateMeter()
    {
        string? version = typeof(NeuronMeter).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion;
        var meter = new Meter("NeuronMocap", version?.Split('+')[0]);

        AddCounter("frames", "{frame}", "Frames received.", static (reader, figures) =>
        {
            ReaderStatistics statistics = figures.GetStatistics();
            return
            [
                reader.Measure(statistics.MotionFrames, MeterTags.Motion),
                reader.Measure(statistics.CalculationFrames, MeterTags.Calculation),
                reader.Measure(statistics.StudioCalculationFrames, MeterTags.StudioCalculation),
            ];
        });
        AddCounter("io", "By", "Bytes of the stream, delivered or skipped.", Total(static total => total.BytesReceived));
        AddCounter("skipped", "By", "Bytes outside packets.", static (reader, figures) => SkipReasons.Select(
            entry => reader.Measure(figures.GetSkipped(entry.Reason), new KeyValuePair<string, object?>(MeterTags.Reason, entry.Tag))));
        AddCounter("refused", "{datagram}", "Datagrams of senders that are not allowed.", Total(static total => total.RefusedDatagrams));
        AddCounter("dropped", "{frame}", "Frames that were dropped because a queue was full.", PerConsumer(static consumer => consumer.Dropped));
        AddCounter("frames.skipped", "{frame}", "Frames that a consumer left out because of its rate.", PerConsumer(static consumer => consumer.Skipped));
        AddCounter("restarts", "{restart}", "How often the server restarted its frame count.", Total(static total => total.Restarts));
        AddCounter("reconnects", "{connection}", "Connections made after the first.", Total(static total => total.Reconnects));
        AddCounter("failures", "{exception}", "Exceptions of the application's handlers.", Total(static total => total.CallbackFailures));

        // These counters can also decrease, because a frame that arrives late is no longer lost.
        AddUpDown("lost", "{frame}", "Frames that the server sent and that did not arrive.", Total(static total => total.Lost));
        AddUpDown("gaps", "{gap}", "Runs of lost frames.", Total(static total => total.Gaps));
        AddUpDown("queue.length", "{frame}", "Frames that wait in queues.", PerConsumer(static consumer => consumer.Waiting));
        AddUpDown("state", "{reader}", "1 for the current state of the connection, 0 for all others.", static (reader, figures) => States.Select(
            entry => reader.Measure(figures.State == entry.State ? 1L : 0L, new KeyValuePair<string, object?>(MeterTags.State, entry.Tag))));
        AddUpDown("receive.buffer", "By", "The system's buffer for datagrams: what it granted, and what was requested.", static (reader, figures) =>
            figures.ReceiveBufferSize is { } granted
                ? [reader.Measure((long)granted, MeterTags.Granted), reader.Measure((long)UdpSocket.WantedBuffer, MeterTags.Requested)]
                : []);
        meter.CreateObservableGauge(Prefix + "frame.age", () => Observe(MeasureAge), "s", "Age of the newest frame.");
        return meter;

        void AddCounter(string name, string unit, string description, Func<ReaderMetrics, IReaderStatistics, IEnumerable<Measurement<long>>> measure) =>
            meter.CreateObservableCounter(Prefix + name, () => Observe(measure), unit, description);

        void AddUpDown(string name, string unit, string description, Func<ReaderMetrics, IReaderStatistics, IEnumerable<Measurement<long>>> measure) =>
            meter.CreateObservableUpDownCounter(Prefix + name, () => Observe(measure), unit, description);
    }

    private static Histogram<double> CreateHistogram(string name, string description, double[] boundaries) => Meter.CreateHistogram(
        Prefix + name, "s", description, tags: null, new InstrumentAdvice<double> { HistogramBucketBoundaries = boundaries });

    private static Func<ReaderMetrics, IReaderStatistics, IEnumerable<Measurement<long>>> Total(Func<ReaderStatistics, long> figure) =>
        (reader, figures) => [reader.Measure(figure(figures.GetStatistics()))];

    private static Func<ReaderMetrics, IReaderStatistics, IEnumerable<Measurement<long>>> PerConsumer(Func<ConsumerStatistics, long> figure) =>
        (reader, figures) => figures.GetConsumers().Select(
            consumer => reader.Measure(figure(consumer), new KeyValuePair<string, object?>(MeterTags.Consumer, consumer.Name)));

    // Returns nothing before the first frame, because there is no age yet.
    private static IEnumerable<Measurement<double>> MeasureAge(ReaderMetrics reader, IReaderStatistics figures)
    {
        long newest = figures.GetStatistics().LastFrameTimestamp;
        return newest == 0 ? [] : [reader.Measure(Math.Max(Stopwatch.GetElapsedTime(newest).TotalSeconds, 0))];
    }

    private static List<Measurement<T>> Observe<T>(Func<ReaderMetrics, IReaderStatistics, IEnumerable<Measurement<T>>> measure)
        where T : struct
    {
        List<Measurement<T>> measurements = [];
        foreach (ReaderMetrics reader in Live())
        {
            if (reader.Figures is { } figures)
                measurements.AddRange(measure(reader, figures));
        }

        return measurements;
    }

    private static List<ReaderMetrics> Live()
    {
        List<ReaderMetrics> live = [];
        lock (Lock)
        {
            foreach ((_, WeakReference<ReaderMetrics> reference) in Readers)
            {
                if (reference.TryGetTarget(out ReaderMetrics? reader))
                    live.Add(reader);
            }
        }

        return live;
    }
}
